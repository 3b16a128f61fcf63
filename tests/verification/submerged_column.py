#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A column of grains collapses in air and under water. Under water the volumes and the momentum are kept, and the grains move
more slowly, a part of them farther than in air and the others less far; a run that is resumed goes on bit for bit, two ranks compute what one does.

    submerged_column.py --lahar PROGRAM --output DIRECTORY [--cases NAME ...]
"""

import shutil
import sys

import numpy as np

from verification import Check, check_balance_of_momentum, deposit, read_run, run_check, volume_changes

CASE, IN_AIR = "granular_column/submerged_column.prm", "granular_column/granular_column.prm"
WIDTH, GRAVITY = 0.074, 9.81
UNIT = np.sqrt(WIDTH / GRAVITY)
names = ["short", "resumed"]
if "--cases" in sys.argv:
    at = sys.argv.index("--cases")
    names = sys.argv[at + 1:]
    del sys.argv[at:]


def settings(n):
    """A mesh of n cells over the height, and a time step for it."""
    return [f"Mesh size={WIDTH / n:.6g}", f"Time step={0.32 / n * UNIT:.6g}", f"Output interval={0.5 * UNIT:.6g}"]


def keep(directory, name):
    """Under another name, for the figure."""
    kept = directory.with_name(name)
    shutil.rmtree(kept, ignore_errors=True)
    return directory.rename(kept)


def run_in_air(check, n, end):
    grains = "Fluids/grains/mu(I)"
    return keep(check.run(
        IN_AIR, *settings(n), f"End time={end * UNIT:.6g}", f"Fluids/grains/box/Corners=0, 0 : {WIDTH}, {WIDTH}",
        f"{grains}/Density=2200", f"{grains}/Grain density=2650", f"{grains}/Grain diameter=0.0017",
        f"{grains}/Static friction=0.408", f"{grains}/Dynamic friction=0.69"), "column_in_air")


def check_column(check, n, end):
    air = deposit(run_in_air(check, n, end), WIDTH)
    directory = keep(check.run(CASE, *settings(n), f"End time={end * UNIT:.6g}"), "column_in_water")
    statistics = read_run(directory)
    water = deposit(directory, WIDTH, 0.)
    half = [np.interp(0.5, way, time / UNIT) for time, way, *rest in (air, water)]
    print(f"  run-out {air[1, -1]:.3f} in air and {water[1, -1]:.3f} in water, 0.5 after {half[0]:.2f} and {half[1]:.2f}; "
          f"of the body {air[2, -1]:.3f} and {water[2, -1]:.3f}; {water[3, -1]:.3f} of the grains run ahead; {statistics['Nonlinear iterations'].sum():.0f} iterations in "
          f"{len(statistics['Time (s)'])} steps; depth of the middle over that in air {water[4, -1] / air[4, -1]:.3f}")
    check.below("time of the first half width in air over that in water", half[0] / half[1], 0.8)
    if n > 8:
        # Where the thin layer behind the head is deeper than 0.1 widths, about two cells, is chance.
        check.near("run-out of the body in water over that in air", water[2, -1] / air[2, -1], 0.7, 0.2)
        check.near("part of the grains that runs ahead", water[3, -1], 0.14, 0.2)
        check.below("... in air", air[3, -1], 0.02)
    for cause, change in zip(("solver", "remeshing"), volume_changes(statistics)):
        check.below(f"volume change by {cause}", change, 1e-3)
    for fluid in ("grains", "water"):
        change = sum(statistics[f"{fluid} volume change by {cause}"] for cause in ("solver", "remeshing"))
        check.below(f"volume change of {fluid}", np.abs(change).max(), 5e-3)
    # Also while pieces of the front tear off, from 4 on: no thin film of them stops the flow.
    check_balance_of_momentum(check, "column in water", statistics, {"grains": 2370., "water": 1000.},
                              ["floor", "plane of symmetry", "far wall"], 5e-3)
    check.below("steps repeated", statistics["Rejected steps"][-1], 0)
    check.below("vertices held", statistics["Held vertices"].sum(), 0)


def compare(check, name, runs, tolerance):
    for column in ("Kinetic energy (J)", "Momentum x (N s)", "Potential energy (J)", "grains volume (m^dim)"):
        a, b = (run[column] for run in runs)
        check.below(f"{name}: {column}, over the largest", np.abs(a - b).max() / np.abs(a).max(), tolerance)


SHORT = ["Mesh size=0.0123", "Time step=4e-3", "Output interval=1"]


def check_resumed(check):
    parts = [*SHORT, "Checkpoint/Steps between=10"]
    whole = read_run(check.run(CASE, *parts, "End time=0.12"))
    check.run(CASE, *parts, "End time=0.08")
    resumed = read_run(check.run(CASE, *parts, "End time=0.12", resume=True))
    compare(check, "resumed", (whole, resumed), 0. if check.n_ranks == 1 else 1e-6)


def check_ranks(check):
    n_ranks, runs = check.n_ranks, []
    for check.n_ranks in (1, n_ranks):
        runs.append(read_run(check.run(CASE, *SHORT, "End time=0.024", "Nonlinear solver/Tolerance=1e-9")))
    compare(check, f"{n_ranks} ranks", runs, 1e-6)


def main():
    check = Check(__doc__)
    checks = {"short": lambda: check_column(check, 8, 6.), "column": lambda: check_column(check, 16, 8.),
              "resumed": lambda: check_resumed(check), "ranks": lambda: check_ranks(check)}
    for name in names:
        checks[name]()
    check.finish()


run_check(main)
