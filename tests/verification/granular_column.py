#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fronts of columns of grains that collapse on a rough floor follow those of computed grains."""

import shutil

import numpy as np

from verification import Check, read_reference, read_run, run_check, volume_changes

CASE = "granular_column/granular_column.prm"
GRAVITY = 9.81
# By the ratio of height and half width: the height and how many mesh sizes it has.
COLUMNS = {"0.5": (0.149, 10), "1.42": (0.324, 16), "6.26": (0.67, 40)}


def main():
    check = Check(__doc__)
    measured = read_reference("granular_column/contact_dynamics_fronts.csv")
    for ratio, (height, n) in COLUMNS.items():
        unit = np.sqrt(height / GRAVITY)
        directory = check.run(
            CASE, f"Fluids/grains/box/Corners=0, 0 : {height / float(ratio):.6g}, {height}",
            f"Mesh size={height / n:.6g}", f"Time step={0.02 * unit:.6g}", f"End time={6. * unit:.6g}",
            f"Output interval={unit:.6g}")
        kept = directory.with_name(f"granular_column_{ratio}")  # for the figure
        shutil.rmtree(kept, ignore_errors=True)
        statistics = read_run(directory.rename(kept))
        time = statistics["Time (s)"] / unit
        fronts, heights = (np.interp(measured["t"][1:], time, statistics[f"{name} (m)"] / height)
                           for name in ("front", "height"))
        grains = measured[f"{ratio} deep"][1:]
        n_iterations = statistics["Nonlinear iterations"].sum()
        print(f"  {ratio}: {n_iterations:.0f} iterations in {len(time)} steps, fronts", fronts)
        check.below(f"{ratio}: front, where three grains lie on each other, relative error",
                    abs(fronts / grains - 1.).max(), 0.1)
        check.below(f"{ratio}: height at rest, over that at the start",
                    abs(heights[-1] - measured[f"{ratio} height"][-1]), 0.04)
        n_warnings = (kept / "screen.txt").read_text().count("equations of the fluid's law are well-posed")
        check.below(f"{ratio}: the warning of ill-posed cells is there once", abs(n_warnings - 1), 0)
        energy = statistics["Kinetic energy (J)"]
        check.below(f"{ratio}: kinetic energy at the end over the largest", energy[-1] / energy.max(), 2e-3)
        for cause, change in zip(("solver", "remeshing"), volume_changes(statistics)):
            check.below(f"{ratio}: volume change by {cause}", change, 1e-3)
    check.finish()


run_check(main)
