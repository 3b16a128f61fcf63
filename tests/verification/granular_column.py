#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fronts of columns of grains that collapse on a rough floor follow those of computed grains."""

import numpy as np

from verification import Check, read_reference, read_run, run_check, volume_changes

CASE = "granular_column/granular_column.prm"
GRAVITY = 9.81
# By the ratio of height and half width: the height, mesh sizes over it, and the tolerance of the front over the height.
COLUMNS = {"0.5": (0.149, 10, 0.5), "1.42": (0.324, 16, 0.5), "6.26": (0.67, 40, 0.5)}


def main():
    check = Check(__doc__)
    measured = read_reference("granular_column/contact_dynamics_fronts.csv")
    for ratio, (height, n, tolerance) in COLUMNS.items():
        unit = np.sqrt(height / GRAVITY)
        statistics = read_run(check.run(
            CASE, f"Fluids/grains/box/Corners=0, 0 : {height / float(ratio):.6g}, {height}", f"Mesh size={height / n:.6g}",
            f"Time step={0.02 * unit:.6g}", f"End time={6. * unit:.6g}", f"Output interval={unit:.6g}"))
        time, front = statistics["Time (s)"] / unit, statistics["front (m)"] / height
        fronts = np.interp(measured["t"][1:], time, front)
        print(f"  {ratio}: fronts {np.round(fronts, 3)}, grains {measured[ratio][1:]}")
        check.below(f"{ratio}: front over the height", np.abs(fronts - measured[ratio][1:]).max(), tolerance)
        for cause, change in zip(("solver", "remeshing"), volume_changes(statistics)):
            check.below(f"{ratio}: volume change by {cause}", change, 0.01)
    check.finish()


run_check(main)
