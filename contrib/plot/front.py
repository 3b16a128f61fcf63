#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draw a column of Lahar's statistics over time, one curve a run.

    front.py output-a="h = 10 mm" output-b="h = 5 mm" -o front.png --column "front (m)"
"""

import argparse
import pathlib

from figure_style import WIDTH, plt, save, use_style
from lahar_output import column, read_statistics, run_script

TIME = "Time (s)"


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="+", metavar="OUTPUT_DIR[=LABEL]", help="output directory of a run, and its name")
    parser.add_argument("-o", "--output", required=True, help="the picture (.png, .pdf, .svg)")
    parser.add_argument("--column", default="front (m)", help="the column drawn (default: %(default)s)")
    return parser.parse_args()


def split_label(run):
    """Output directory and label in 'OUTPUT_DIR=LABEL'; without label the directory's name serves."""
    directory, separator, label = run.partition("=")
    if pathlib.Path(run).is_dir() or not separator:
        return pathlib.Path(run), pathlib.Path(run).resolve().name
    return pathlib.Path(directory), label


def draw_run(axes, directory, label, name):
    path = directory / "statistics"
    statistics = read_statistics(path)
    axes.plot(column(statistics, TIME, path), column(statistics, name, path), label=label)


def main():
    arguments = parse_arguments()
    use_style()
    figure, axes = plt.subplots(figsize=(0.65 * WIDTH, 0.42 * WIDTH))
    for run in arguments.runs:
        draw_run(axes, *split_label(run), arguments.column)
    axes.set(xlabel="time (s)", ylabel=arguments.column)
    axes.margins(x=0)
    axes.grid(linewidth=0.4, color="0.88")
    axes.tick_params(top=True, right=True)
    if len(arguments.runs) > 1 or "=" in arguments.runs[0]:
        axes.legend()
    save(figure, arguments.output)


if __name__ == "__main__":
    run_script(main)
