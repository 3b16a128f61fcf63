#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A column of grains collapses in air and under water. Under water the volumes and the momentum are kept, the grains come to
rest and run out less far and more slowly than in air, as computed discs do; a run that is resumed goes on bit for bit, two
ranks compute what one does.

    submerged_column.py --lahar PROGRAM --output DIRECTORY [--cases NAME ...]
"""

import shutil
import sys

import numpy as np

from verification import Check, check_balance_of_momentum, fluid_fronts, read_run, run_check, volume_changes

CASE, IN_AIR = "granular_column/submerged_column.prm", "granular_column/granular_column.prm"
WIDTH, GRAVITY = 0.074, 9.81
UNIT = np.sqrt(WIDTH / GRAVITY)
# Run-out over the width of discs, in air and in water: figure 6.13 of Kumar (2015).
DISCS = {"air": 2.93, "water": 2.12}
names = ["short", "resumed", "ranks"]
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


def run_out(times, fronts):
    """Over the width at the start, and the time in which the grains run nine tenths of it over sqrt(H/g)."""
    way = np.array(fronts) / WIDTH - 1.
    return way[-1], np.interp(0.9 * way[-1], way, times) / UNIT


def check_column(check, n, end):
    statistics = read_run(run_in_air(check, n, end))
    air, air_time = run_out(statistics["Time (s)"], statistics["front (m)"])
    directory = keep(check.run(CASE, *settings(n), f"End time={end * UNIT:.6g}"), "column_in_water")
    statistics = read_run(directory)
    times, fronts = fluid_fronts(directory)
    water, water_time = run_out(times, [front[0][1] for front in fronts])
    print(f"  run-out {air:.3f} in air and {water:.3f} in water, 0.9 of it after {air_time:.2f} and {water_time:.2f}; "
          f"{statistics['Nonlinear iterations'].sum()} iterations in {len(statistics['Time (s)'])} steps")
    check.near("run-out in water over that in air, that of discs", water / air, DISCS["water"] / DISCS["air"], 0.2)
    check.below("time in air over that in water", air_time / water_time, 0.8)
    way = np.array([front[0][1] for front in fronts])
    check.below("way of the front in the last tenth of the time, over the width", (way[-1] - np.interp(0.9 * times[-1], times, way)) / WIDTH, 0.05)
    for cause, change in zip(("solver", "remeshing"), volume_changes(statistics)):
        check.below(f"volume change by {cause}", change, 1e-3)
    for fluid in ("grains", "water"):
        change = sum(statistics[f"{fluid} volume change by {cause}"] for cause in ("solver", "remeshing"))
        check.below(f"volume change of {fluid}", np.abs(change).max(), 5e-3)
    check_balance_of_momentum(check, "column in water", statistics, {"grains": 2370., "water": 1000.},
                              ["floor", "plane of symmetry", "far wall"], 2e-3)
    check.below("steps repeated, over all", statistics["Rejected steps"][-1] / len(statistics["Time (s)"]), 0.02)


def compare(check, name, runs, tolerance):
    for column in ("Kinetic energy (J)", "Momentum x (N s)", "Potential energy (J)", "grains volume (m^dim)"):
        a, b = (run[column] for run in runs)
        check.below(f"{name}: {column}, over the largest", np.abs(a - b).max() / np.abs(a).max(), tolerance)


def check_resumed(check):
    short = [*settings(6), "Checkpoint/Steps between=10"]
    whole = read_run(check.run(CASE, *short, f"End time={1.6 * UNIT:.6g}"))
    check.run(CASE, *short, f"End time={UNIT:.6g}")
    resumed = read_run(check.run(CASE, *short, f"End time={1.6 * UNIT:.6g}", resume=True))
    compare(check, "resumed", (whole, resumed), 0. if check.n_ranks == 1 else 1e-6)


def check_ranks(check):
    if check.n_ranks == 1:
        return
    n_ranks, runs = check.n_ranks, []
    for check.n_ranks in (1, n_ranks):
        runs.append(read_run(check.run(CASE, *settings(6), f"End time={1.2 * UNIT:.6g}", "Nonlinear solver/Tolerance=1e-9")))
    compare(check, f"{n_ranks} ranks", runs, 1e-6)


def main():
    check = Check(__doc__)
    checks = {"short": lambda: check_column(check, 8, 6.), "column": lambda: check_column(check, 16, 10.),
              "resumed": lambda: check_resumed(check), "ranks": lambda: check_ranks(check)}
    for name in names:
        checks[name]()
    check.finish()


run_check(main)
