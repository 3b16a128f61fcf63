#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""V5: the semi-axes of the inviscid drop follow the exact solution; volume and energy are kept."""

import numpy as np

from verification import Check, at_time, read_reference, read_run, run_check, volume_changes


def main():
    check = Check(__doc__)
    statistics = read_run(check.run("elliptic_drop/elliptic_drop.prm"))
    exact = read_reference("elliptic_drop/evolving_elliptic_drop.csv")
    for time in (3.8e-3, 7.6e-3):
        row = int(np.argmin(abs(exact["t"] - time)))
        a = 0.5 * (at_time(statistics, "right (m)", time) - at_time(statistics, "left (m)", time))
        b = 0.5 * (at_time(statistics, "top (m)", time) - at_time(statistics, "bottom (m)", time))
        check.near(f"semi-axis x at {1e3 * time:.1f} ms (m)", a, exact["a_x"][row], 0.01)
        check.near(f"semi-axis y at {1e3 * time:.1f} ms (m)", b, exact["b_y"][row], 0.01)
    energy = statistics["Kinetic energy (J)"]
    check.below("change of energy", abs(energy / energy[0] - 1.).max(), 1e-3)
    for cause, change in zip(("solver", "remeshing"), volume_changes(statistics)):
        check.below(f"volume change by {cause}", change, 1e-3)
    check.finish()


run_check(main)
