#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The account of the volume where fluid breaks up, merges, lands and is moved: the solver keeps it to 1e-4 at every
moment, remeshing to 0.5 % of the volume; where whole films and drops of a few cells come and go, to 1 %. What
leaves the domain is no change by remeshing.

    volume.py --lahar PROGRAM --output DIRECTORY [--cases NAME ...]
"""

import sys

from verification import Check, read_run, run_check, volume_changes

# Largest change by remeshing that is allowed.
CASES = {"merging_drops": 0.01, "drum": 0.01, "sloshing": 0.005, "elastic_gate": 0.005, "perforated_plate": 0.005,
         "obstacle_3d": 0.005, "obstacle_3d_coarse": 0.005, "leaving_3d": 1e-5}
# Shorter variants: the case and other entries.
VARIANTS = {"obstacle_3d_coarse": ("obstacle_3d", "Mesh size=0.028", "Time step=2.5e-3", "End time=0.25")}
# Steps that may be repeated in space, where there are flat cells everywhere.
REPEATED = {"obstacle_3d": 20, "obstacle_3d_coarse": 5}
names = ["merging_drops", "drum", "sloshing", "obstacle_3d_coarse", "leaving_3d"]
if "--cases" in sys.argv:
    at = sys.argv.index("--cases")
    names = sys.argv[at + 1:]
    del sys.argv[at:]


def main():
    check = Check(__doc__)
    for name in names:
        case, *entries = VARIANTS.get(name, (name,))
        statistics = read_run(check.run(f"volume/{case}.prm", *entries))
        solver, remeshing = volume_changes(statistics)
        check.below(f"{name}, volume change by the solver", solver, 1e-4)
        check.below(f"{name}, volume change by remeshing", remeshing, CASES[name])
        if name == "leaving_3d":
            check.near("leaving_3d, volume that has left", statistics["Volume left the domain"][-1], 0.05, 0.2)
        if name in REPEATED:
            check.below(f"{name}, repeated steps", statistics["Rejected steps"][-1], REPEATED[name])
            inside = statistics["inside (m)"]  # no number where there is no fluid
            check.below(f"{name}, steps with fluid in the obstacle", sum(inside == inside), 0)
    check.finish()


run_check(main)
