#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Forces on a solid and the displacement of a point of it, in time.

    contrib/plot/barrier.py output-barrier --solid barrier --point crest --along=-x --mean 0.5 --to barrier_force.png

The force of the fluid step by step and its mean over a sliding time, that of the support, and the displacement, all along
one axis; '-x' turns the sign round. The largest of each, the impulses and what fluid and support together leave over go to
standard output (doc/forces.md).
"""

import argparse
import pathlib

import numpy as np

from figure_style import WIDTH, finish_axes, plt, save, use_style
from lahar_output import OutputError, column, read_statistics, run_script


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", type=pathlib.Path, help="output directory of a run with solids")
    parser.add_argument("--solid", required=True, help="its name")
    parser.add_argument("--point", help="name of a point of 'Postprocess/Solid points'")
    parser.add_argument("--along", default="x", choices=[sign + axis for sign in ("", "-") for axis in "xyz"],
                        help="the axis (default: x); write --along=-x")
    parser.add_argument("--mean", type=float, default=0.5, help="time of the sliding mean, s (default: 0.5)")
    parser.add_argument("--to", type=pathlib.Path, default=pathlib.Path("barrier_force.png"), help="the picture")
    arguments = parser.parse_args()
    if not 0. < arguments.mean < float("inf"):
        raise OutputError(f"--mean is {arguments.mean:g}; allowed: a time above 0, in s")
    return arguments


def sliding_mean(times, steps, force, length):
    """Means of a force over the last @p length (s), at the ends of the steps."""
    edges, impulse = np.r_[times[0] - steps[0], times], np.r_[0., np.cumsum(force * steps)]
    return (impulse[1:] - np.interp(times - length, edges, impulse)) / length


def main():
    arguments = parse_arguments()
    use_style()
    path = arguments.output / "statistics"
    statistics = read_statistics(path)
    sign, axis = -1. if arguments.along[0] == "-" else 1., arguments.along[-1]
    times, steps = column(statistics, "Time (s)", path), column(statistics, "Time step size (s)", path)
    fluid = sign * column(statistics, f"{arguments.solid} fluid force {axis} (N)", path)
    support = sign * column(statistics, f"{arguments.solid} support force {axis} (N)", path)
    mean = sliding_mean(times, steps, fluid, arguments.mean)
    figure, axes = plt.subplots(1, 2 if arguments.point else 1, figsize=(WIDTH, 2.6), squeeze=False, constrained_layout=True)
    axes[0][0].plot(times, 1e-6 * fluid, color="0.7", linewidth=0.8, label="fluid, step by step")
    axes[0][0].plot(times, 1e-6 * mean, label=f"fluid, mean over {arguments.mean:g} s")
    axes[0][0].plot(times, -1e-6 * support, linestyle="--", linewidth=1., label="− support")
    finish_axes(axes[0][0], xlabel="t (s)", ylabel=f"force along {arguments.along} (MN)")
    lines = [f"force of the fluid: largest {fluid.max():.4g} N at {times[fluid.argmax()]:g} s",
             f"its mean over {arguments.mean:g} s: largest {mean.max():.4g} N until {times[mean.argmax()]:g} s",
             f"impulses: fluid {fluid @ steps:.6g}, support {support @ steps:.6g} N s"]
    if arguments.point:
        displacement = sign * column(statistics, f"{arguments.point} {axis} (m)", path)
        axes[0][1].plot(times, displacement)
        finish_axes(axes[0][1], xlabel="t (s)", ylabel=f"{arguments.point} along {arguments.along} (m)")
        lines.append(f"{arguments.point}: largest {displacement.max():.4g} m at {times[displacement.argmax()]:g} s, "
                     f"at the end {displacement[-1]:.4g} m")
    save(figure, arguments.to)
    print("\n".join(lines))


if __name__ == "__main__":
    run_script(main)
