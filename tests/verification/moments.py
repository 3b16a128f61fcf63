#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Moments of the fluid's forces: of water at rest on walls and on a dam, in the plane and in space, and the torques on two
cylinders between which a fluid is sheared."""

import numpy as np

from verification import Check, read_run, run_check

WEIGHT = 9810.


def largest_error(statistics, column, exact, start=0):
    """The largest error from the line @p start on, over the exact value; of the mean column's last value, too."""
    mean = column.replace(" fluid ", " mean fluid ").replace(" support ", " mean support ")
    if mean == column:
        mean = column.replace(" moment", " mean moment")
    return max(abs(statistics[column][start:] / exact - 1.).max(), abs(statistics[mean][-1] / exact - 1.))


def main():
    check = Check(__doc__)
    height, width, spacing = 0.2, 0.3, 0.02
    statistics = read_run(check.run("moments/retained_water.prm"))
    on_wall = WEIGHT * height**3 / 6.
    dam = 2500. * 9.81 * 0.06 * 0.24
    for what, column, exact in [
            ("rigid wall", "wall moment (N m)", on_wall),
            ("dam", "dam fluid moment (N m)", -on_wall),
            ("support of the dam", "dam support moment (N m)", on_wall + 0.03 * dam),
            # What the floor's last particle bears is the dam's, which has it.
            ("floor", "floor moment (N m)", -WEIGHT * height * (0.5 * width**2 - 0.5 * spacing * width))]:
        # The dam is set in motion by the water, by some 1e-14 m; after a few steps it is at rest.
        check.below(f"{what}: error of the moment of water at rest", largest_error(statistics, column, exact, 5), 1e-6)

    width = 0.12
    statistics = read_run(check.run("moments/tank.prm"))
    check.below("wall in space: error of the moment along y",
                largest_error(statistics, "wall moment y (N m)", -WEIGHT * height**3 * width / 6.), 1e-6)
    check.below("wall in space: error of the moment along z",
                largest_error(statistics, "wall moment z (N m)", WEIGHT * height**2 * width**2 / 4.), 1e-6)
    weight = WEIGHT * 0.16 * width * height
    for d, arm in (("x", -0.5 * width), ("y", 0.5 * 0.16)):
        found = sum(statistics[f"{part} moment {d} (N m)"] for part in ("wall", "tank"))
        check.below(f"all walls in space: error of the moment of the water's weight along {d}",
                    abs(found / (arm * weight) - 1.).max(), 1e-6)

    if check.n_ranks > 1:  # the rest would take long, and is no different
        check.finish()
        return
    inner, outer, viscosity, turning = 0.055, 0.1, 5., 4.
    torque = 4. * np.pi * viscosity * turning * inner**2 * outer**2 / (outer**2 - inner**2)
    statistics = read_run(check.run("couette/couette.prm",
                                    "Postprocess/Moments/Points=inner cylinder: 0, 0; outer cylinder: 0, 0"))
    for column, sign in (("inner cylinder fluid moment (N m)", -1.), ("inner cylinder support moment (N m)", 1.),
                         ("outer cylinder moment (N m)", 1.)):
        check.below(f"{column}: error of the torque", abs(statistics[column][-1] / (sign * torque) - 1.), 5e-3)
    check.finish()


run_check(main)
