#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Thixotropic fluids have the structure of closed forms: at rest in a tank, and between cylinders, whose turning remeshes them
in every step, on the way to the steady state and in it; what has built up slumps less far.

    thixotropy.py --lahar PROGRAM --output DIRECTORY [--cases NAME ...]
"""

import sys

import numpy as np

from verification import Check, last_mesh, read_run, run_check

INNER, OUTER, TURNING = 0.055, 0.1, 4.  # radii in m, rad/s, as in couette.prm
RATE = 2. * TURNING * INNER**2 * OUTER**2 / (OUTER**2 - INNER**2)  # of a Newtonian fluid times r², m²/s
TIME = 0.05  # T
names = ["rest", "slump", "transient", "steady"]
if "--cases" in sys.argv:
    at = sys.argv.index("--cases")
    names = sys.argv[at + 1:]
    del sys.argv[at:]


def check_rest(check):
    run = read_run(check.run("thixotropy/rest.prm"))
    check.below("rest: structure", np.abs(run["Mean structure"] / (0.5 + run["Time (s)"] / 2.) - 1.).max(), 1e-6)


def check_couette(check, name, alpha, tolerance):
    """The yield stress is too small to change the Newtonian flow, which is steady from the first step on."""
    directory = check.run("couette/couette.prm", "Fluids/fluid/Law=Bingham",
                          *(f"Fluids/fluid/Bingham/{entry}" for entry in (
                              "Density=10", "Plastic viscosity=5", "Yield stress=1e-3", f"Flocculation time={TIME}",
                              f"Deflocculation parameter={alpha}")))
    mesh = last_mesh(directory)
    corners = mesh.points[mesh.triangles]
    rate = RATE / np.sum(corners.mean(axis=1)**2, axis=1)
    time = read_run(directory)["Time (s)"][-1]
    exact = -np.expm1(-alpha * rate * time) / (TIME * alpha * rate)
    error = mesh.at_cells("structure") / exact - 1.
    check.below(f"{name}: root of the mean square of the structure's error", float(np.sqrt(np.mean(error**2))), tolerance)
    check.below(f"{name}: mean of the error", abs(float(np.mean(error))), tolerance)


def check_slump(check):
    """A block that has rested before it is let go."""
    fronts = []
    for settings in ([], ["Initial structure=1", "Deflocculation parameter=1000"], ["Initial structure=1"]):
        run = read_run(check.run("thixotropy/slump.prm", *(f"Fluids/mud/Bingham/{entry}" for entry in settings)))
        fronts.append(run["right (m)"][-1])
    fresh, broken, built = fronts
    check.below("slump: front of what has built up over that of fresh fluid", built / fresh, 0.97, f"{built:.4f}, {fresh:.4f}, ")
    check.below("slump: what flow breaks down at once goes as far as fresh fluid", abs(broken / fresh - 1.), 0.02,
                f"{broken:.4f}, {fresh:.4f}, ")


def main():
    check = Check(__doc__)
    checks = {"rest": check_rest, "slump": check_slump,
              "transient": lambda c: check_couette(c, "shear, on the way", 1., 0.03),
              "steady": lambda c: check_couette(c, "steady shear", 20., 0.03)}
    for name in names:
        checks[name](check)
    check.finish()


run_check(main)
