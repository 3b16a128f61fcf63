#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Water that leaves a tank below a gate: discharge, level and displacement of the gate's tip in time, of several runs.

    contrib/plot/gate.py output-gate-h5 output-gate-h2.5 --labels "5 mm" "2.5 mm" --gate 0.1 --to elastic_gate.png
    contrib/plot/gate.py output-rigid-gate --gate 0.1 --opening 0.01 --to rigid_gate.png

What is in the tank is the area of the snapshots' triangles left of the gate, cut at it; the discharge is what it loses
from snapshot to snapshot. With --opening it is compared with a jet that contracts below a sharp edge, fed by a tank that
is at rest (doc/benchmarks/elastic_gate.md). Where runs have a solid point 'tip' its displacement is drawn beside the
measurements of the elastic gate. A table of all runs goes to standard output.
"""

import argparse
import pathlib

import numpy as np

from figure_style import WIDTH, finish_axes, plt, save, use_style
from lahar_output import OutputError, column, read_pvd, read_statistics, read_vtu, run_script

GRAVITY = 9.81
CONTRACTION = np.pi / (np.pi + 2.)  # of a free jet below a sharp vertical edge, far below the surface

# C. Antoci, M. Gallati, S. Sibilla, Computers & Structures 85 (2007) 879-890, experiment: displacement (mm) of the tip
# along x and y every 0.04 s, read from a plot by others (github.com/dineshadepu/fsi_etvf after Ng et al. 2020).
MEASURED_TIMES = 0.04 * np.arange(1, 10)
MEASURED = {"x": (12.5, 34.0, 44.0, 46.4, 44.2, 43.0, 41.2, 40.0, 37.4),
            "y": (1.1, 10.0, 15.1, 17.1, 16.0, 13.9, 12.8, 12.0, 10.9)}


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("outputs", type=pathlib.Path, nargs="+", help="output directories of runs in the plane")
    parser.add_argument("--labels", nargs="+", help="of the runs (default: their directories)")
    parser.add_argument("--gate", type=float, required=True, help="x of the gate, m")
    parser.add_argument("--opening", type=float, help="height of the opening below a rigid gate, m")
    parser.add_argument("--to", type=pathlib.Path, default=pathlib.Path("gate.png"), help="the picture (default: gate.png)")
    arguments = parser.parse_args()
    if arguments.labels and len(arguments.labels) != len(arguments.outputs):
        raise OutputError(f"--labels has {len(arguments.labels)} names; allowed: one for each of {len(arguments.outputs)} runs")
    return arguments


def area_left_of(mesh, x):
    """Area of the triangles' parts with a smaller first coordinate than @p x, m²."""
    corners = mesh.points[mesh.cells]
    sides = corners[:, 1:] - corners[:, :1]
    area = 0.5 * abs(sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0])
    low, middle, high = np.sort(corners[:, :, 0], axis=1).T
    with np.errstate(divide="ignore", invalid="ignore"):
        one_corner = (x - low)**2 / ((middle - low) * (high - low))
        two_corners = 1. - (high - x)**2 / ((high - middle) * (high - low))
    return area @ np.select([high <= x, middle <= x, low < x], [1., two_corners, one_corner], 0.)


class Run:
    """What is drawn of a run: the tank's contents, level and tip."""

    def __init__(self, directory, gate):
        snapshots = read_pvd(directory / "solution.pvd")
        self.times = np.array([time for time, _ in snapshots])
        self.in_tank = np.array([area_left_of(read_vtu(path), gate) for _, path in snapshots])
        self.statistics = read_statistics(directory / "statistics")
        self.steps = column(self.statistics, "Time (s)", directory)
        self.level = column(self.statistics, "level (m)", directory)
        self.tip = {axis: self.statistics.get(f"tip {axis} (m)") for axis in "xy"}

    def discharge(self):
        """Times in the middle of the output intervals, s, and the discharge there, m²/s."""
        return 0.5 * (self.times[1:] + self.times[:-1]), -np.diff(self.in_tank) / np.diff(self.times)

    def left(self, time):
        """What has left the tank until then, m²."""
        return self.in_tank[0] - np.interp(time, self.times, self.in_tank)


def jet(opening, width, level, end, n_steps=4000):
    """Level (m) and discharge (m²/s) of a tank that empties by the contracted jet, by time: the pressure at the gate is
    that of water at rest, less the velocity head of the tank's own motion."""
    times, step = np.linspace(0., end, n_steps + 1), end / n_steps
    levels, discharges = [], []
    for _ in times:
        depth = CONTRACTION * opening
        discharge = depth * np.sqrt(2. * GRAVITY * (level - depth) / (1. - (depth / level)**2))
        levels.append(level)
        discharges.append(discharge)
        level -= step * discharge / width
    return times, np.array(levels), np.array(discharges)


def print_table(runs, labels):
    instants = (0.05, 0.1, 0.2, 0.3, 0.4)
    print("run | left the tank at " + ", ".join(f"{time:g}" for time in instants)
          + " s (l/m) | level there (mm) | largest tip x (mm), at (s) | tip x, y at 0.08, 0.16, 0.24, 0.32 s (mm)")
    for run, label in zip(runs, labels):
        words = [", ".join(f"{1e3 * run.left(time):.2f}" for time in instants),
                 ", ".join(f"{1e3 * np.interp(time, run.steps, run.level):.1f}" for time in instants)]
        if run.tip["x"] is not None:
            largest = run.tip["x"].argmax()
            words += [f"{1e3 * run.tip['x'][largest]:.1f}, {run.steps[largest]:.3f}",
                      "; ".join(", ".join(f"{1e3 * np.interp(time, run.steps, run.tip[axis]):.1f}"
                                          for time in (0.08, 0.16, 0.24, 0.32)) for axis in "xy")]
        print(" | ".join([label, *words]))


def main():
    arguments = parse_arguments()
    use_style()
    runs = [Run(output, arguments.gate) for output in arguments.outputs]
    labels = arguments.labels or [str(output) for output in arguments.outputs]
    has_tip = any(run.tip["x"] is not None for run in runs)
    figure, axes = plt.subplots(1, 3 if has_tip else 2, figsize=(WIDTH, 2.7), constrained_layout=True)
    for run, label in zip(runs, labels):
        times, discharge = run.discharge()
        axes[0].plot(times, 1e3 * discharge, label=label, linewidth=1.)
        axes[1].plot(run.steps, 1e3 * run.level, label=label, linewidth=1.)
        if run.tip["x"] is not None:
            line, = axes[2].plot(run.steps, 1e3 * run.tip["x"], linewidth=1.)
            axes[2].plot(run.steps, 1e3 * run.tip["y"], color=line.get_color(), linestyle="--", linewidth=1.)
    end = max(run.times[-1] for run in runs)
    if arguments.opening:
        times, level, discharge = jet(arguments.opening, arguments.gate, runs[0].level[0], end)
        axes[0].plot(times, 1e3 * discharge, color="0.5", linestyle="--", label="contracted jet")
        axes[1].plot(times, 1e3 * level, color="0.5", linestyle="--", label="contracted jet")
    if has_tip:
        axes[2].plot(MEASURED_TIMES, MEASURED["x"], "ko", markersize=3, label="measured")
        axes[2].plot(MEASURED_TIMES, MEASURED["y"], "ko", markersize=3, fillstyle="none")
        finish_axes(axes[2], "upper left", xlabel="t (s)", ylabel="tip, x (lines) and y (dashed) (mm)")
        axes[2].set_ylim(top=1.2 * max(*MEASURED["x"], *(1e3 * run.tip["x"].max() for run in runs if run.tip["x"] is not None)))
    finish_axes(axes[0], xlabel="t (s)", ylabel="discharge (l/(s m))")
    finish_axes(axes[1], xlabel="t (s)", ylabel="level at the back (mm)")
    for axis in axes:
        axis.set_xlim(0., end)
        axis.set_ylim(bottom=0.)
    save(figure, arguments.to)
    print_table(runs, labels)


if __name__ == "__main__":
    run_script(main)
