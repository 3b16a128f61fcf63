#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""V1: fluid at rest has the hydrostatic pressure to round-off and stays at rest."""

from verification import Check, read_run, run_check, volume_changes

HEIGHT, WEIGHT = 0.2, 9810.
GAUGES = {"a": 0.002, "b": 0.05, "c": 0.0973, "d": 0.15, "e": 0.195}  # name in the .prm files, height in m
MASS = 20.


def main():
    check = Check(__doc__)
    for name in ("newtonian_no_slip", "newtonian_slip", "bingham_no_slip", "bingham_slip"):
        statistics = read_run(check.run(f"hydrostatic_column/{name}.prm"))
        error = max(abs(statistics[f"{gauge} pressure (Pa)"] + WEIGHT * (HEIGHT - y)).max() for gauge, y in GAUGES.items())
        speed = max(abs(statistics[f"{gauge} velocity {d} (m/s)"]).max() for gauge in GAUGES for d in "xy")
        kinetic_energy = abs(statistics["Kinetic energy (J)"]).max()
        check.below(f"{name}, pressure over that at the bottom", error / (WEIGHT * HEIGHT), 1e-8)
        check.below(f"{name}, speed at the gauges (m/s)", speed, 1e-10)
        check.below(f"{name}, mean speed from the kinetic energy (m/s)", (2. * kinetic_energy / MASS)**0.5, 1e-10)
        for cause, change in zip(("solver", "remeshing"), volume_changes(statistics)):
            check.below(f"{name}, volume change by {cause}", change, 1e-12)
    check.finish()


run_check(main)
