#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How round the rim of a flow about the axis z is, of several runs in space.

    contrib/plot/rim.py output-mini-cone --times 0.1 0.5 1 5
    contrib/plot/rim.py landed carried --labels "fluid lands" "wall particles" --times 5 --to rim.png

The rim is what of the fluid is farthest from the axis, in sectors 1.5 mesh sizes wide. A table goes to standard output: its
mean diameter, and over the mesh size its standard deviation over the angle, its range, and the largest change of the
spread in one direction in a step in the rest of the run (columns 'spread...' of Fluid extents). With --to the rims at
the last of the times are drawn, less their means, by the angle.
"""

import argparse
import pathlib

import numpy as np

from figure_style import WIDTH, finish_axes, plt, save, use_style
from lahar_output import OutputError, nearest_snapshots, read_parameter, read_pvd, read_statistics, read_vtu, run_script
from mesh_geometry import rim_radius

TIME = "Time (s)"


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("outputs", type=pathlib.Path, nargs="+", help="output directories of runs in space")
    parser.add_argument("--labels", nargs="+", help="of the runs (default: their directories)")
    parser.add_argument("--times", type=float, nargs="+", help="the snapshots nearest to these times, s (default: the last)")
    parser.add_argument("--to", type=pathlib.Path, help="a picture of the rims at the last of the times")
    arguments = parser.parse_args()
    if arguments.labels and len(arguments.labels) != len(arguments.outputs):
        raise OutputError(f"--labels has {len(arguments.labels)} names; allowed: one for each of {len(arguments.outputs)} runs")
    return arguments


def mesh_size(directory):
    """The entry `Mesh size` of a run, m."""
    path = directory / "parameters.prm"
    text = read_parameter(path, [], "Mesh size")
    try:
        return float(text)
    except ValueError:
        raise OutputError(f"{path}: 'Mesh size' is '{text}'; allowed: a number") from None


def largest_jump(statistics, start):
    """The largest change of one of the columns 'spread...' in one step after the time @p start, m; nan without any."""
    times = statistics[TIME]
    spreads = [values for name, values in statistics.items() if name.startswith("spread")]
    late = times[1:] > start
    return max((np.abs(np.diff(values)[late]).max() for values in spreads), default=np.nan) if late.any() else np.nan


class Run:
    """The rims of a run: by snapshot its time, s, and radii by sector, m."""

    def __init__(self, directory, label, times):
        self.label, self.size = label, mesh_size(directory)
        snapshots = read_pvd(directory / "solution.pvd")
        chosen = nearest_snapshots(snapshots, times or [snapshots[-1][0]])
        self.rims = [(time, rim_radius(read_vtu(path, 3).points, self.size)) for time, path in chosen]
        self.statistics = read_statistics(directory / "statistics")

    def print_rows(self):
        for time, rim in self.rims:
            jump = largest_jump(self.statistics, time) / self.size
            print(f"{self.label} | {1e3 * self.size:g} | {time:g} | {2. * rim.mean():.4f} | {rim.std() / self.size:.3f} | "
                  f"{np.ptp(rim) / self.size:.2f} | {'–' if np.isnan(jump) else f'{jump:.2f}'}")

    def draw(self, axes):
        time, rim = self.rims[-1]
        angles = 360. * np.arange(len(rim) + 1) / len(rim) - 180.
        axes.stairs((rim - rim.mean()) / self.size, angles, baseline=None, label=f"{self.label}, {time:.3g} s")


def main():
    arguments = parse_arguments()
    labels = arguments.labels or [str(output) for output in arguments.outputs]
    runs = [Run(output, label, arguments.times) for output, label in zip(arguments.outputs, labels)]
    print("run | h (mm) | time (s) | mean diameter of the rim (m) | standard deviation / h | range / h | largest jump after / h")
    for run in runs:
        run.print_rows()
    if arguments.to:
        use_style()
        figure, axes = plt.subplots(figsize=(0.8 * WIDTH, 0.35 * WIDTH))
        for run in runs:
            run.draw(axes)
        finish_axes(axes, xlabel="angle (degrees)", ylabel="radius less its mean, over h")
        axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.), ncol=3)
        axes.set_xticks(range(-180, 181, 45))
        save(figure, arguments.to)


if __name__ == "__main__":
    run_script(main)
