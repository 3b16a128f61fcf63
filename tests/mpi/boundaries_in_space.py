#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Boundaries in space on 1, 2 and 4 ranks: with tight tolerances all columns of the statistics and the particles of the last
snapshot are the same to 1e-8, and a run that is resumed while boundaries move and fluid comes in is, bit for bit, the one
that is not.

LAW:     a box of a Bingham fluid on a floor of this law that turns about an upright axis, between walls of the other laws:
         one that pushes by a function of time, one that follows a table, and two that stand. Each law has each motion.
inflow:  a channel that fluid comes into by a table and leaves against a level.
all:     all of these.

Usage: boundaries_in_space.py GROUP LAHAR MPIEXEC
"""
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "contrib", "plot"))

import numpy as np  # noqa: E402

from lahar_output import read_pvd, read_statistics, read_vtu  # noqa: E402
from program_test import check, failed, new_case, on_ranks, parts, section, shape, wall  # noqa: E402

LAHAR, MPIEXEC = os.path.abspath(sys.argv[2]), sys.argv[3]
RANKS = (1, 2, 4)
TOLERANCE = 1e-8
MESH_SIZE = 0.03  # m
MIDDLE, MIDDLE_OF_INFLOW = 0.03, 0.05  # of a run, s; a part of it ends there

# By name: the entries of each law, whose tractions are of the size of the fluid's weight.
LAWS = {"Coulomb": section("Coulomb", "set Friction coefficient = 0.3", "set Cohesion = 20"),
        "Navier slip": section("Navier slip", "set Slip coefficient = 2000"),
        "yield slip": section("yield slip", "set Sliding yield stress = 100", "set Slip coefficient = 500"),
        "no slip": "", "free slip": ""}

HEAD = f"""
set Dimension        = 3
set Output directory = out
set Time step        = 5e-3
set Mesh size        = {MESH_SIZE:g}
set Gravity          = 0.5, 0.3, -9.81
""" + section("Nonlinear solver", "set Tolerance = 1e-10", "set Maximum iterations = 60") + \
    section("Linear solver", "set Type = direct", section("Direct", "set Package = KLU", "set Tolerance = 0"))

FLUID = "set Law = Bingham\n" + section("Bingham", "set Density = 1500", "set Plastic viscosity = 20", "set Yield stress = 50",
                                        "set Regularization parameter = 100")

GAUGES = section("Postprocess", section("Point gauges", "set Points = inside: 0.07, 0.06, 0.03"),
                 section("Fluid extents", "set Extents = left: min x, right: max x, front: min y, back: max y, top: max z"))


def until(middle):
    """The run's end, and a snapshot in the middle, with which mean forces begin anew, as at the end of a part."""
    return f"set End time = {2. * middle:g}\nset Output interval = {middle:g}\n"


def motion(kind, *settings):
    return f"set Motion = {kind}\n" + section(kind, *("set " + setting for setting in settings))


def rectangle(axis, position, low, high):
    """Corners of a rectangle across an axis."""
    a, b = (k for k in range(3) if k != axis)
    corners = []
    for along_a, along_b in ((low, low), (high, low), (high, high), (low, high)):
        corner = [position] * 3
        corner[a], corner[b] = along_a[a], along_b[b]
        corners.append(", ".join(f"{value:g}" for value in corner))
    return " : ".join(corners)


def box_case(law):
    """The floor has this law, the other walls the ones that follow."""
    names = list(LAWS)
    first = names.index(law)
    order = [names[(first + k) % len(names)] for k in range(len(names))]
    low, high = (-0.1, -0.1, -0.02), (0.25, 0.2, 0.2)
    boundaries = {
        "floor": wall(rectangle(2, 0., (-0.2, -0.2, 0.), (0.4, 0.4, 0.)), order[0]) + LAWS[order[0]] +
        motion("rotation", "Centre = 0.05, 0.04, 0", "Axis = 0, 0, 1", "Angle = 20 * t^2"),
        "pusher": wall(rectangle(0, 0., low, high), order[1]) + LAWS[order[1]] +
        motion("translation", "Displacement = 2 * t^2; 0.2 * t; 0"),
        "follower": wall(rectangle(0, 0.15, low, high), order[2]) + LAWS[order[2]] + motion("table", "File = way.csv"),
        "left": wall(rectangle(1, 0., low, high), order[3]) + LAWS[order[3]],
        "right": wall(rectangle(1, 0.12, low, high), order[4]) + LAWS[order[4]]}
    return HEAD + until(MIDDLE) + parts("Boundaries", boundaries) + \
        parts("Fluids", {"mud": shape("box", "Corners = 0, 0, 0 : 0.15, 0.12, 0.09") + FLUID}) + GAUGES


def inflow_case():
    low, high = (0., 0., 0.), (0.18, 0.12, 0.15)
    boundaries = {
        "floor": wall(rectangle(2, 0., low, high), "Navier slip") + LAWS["Navier slip"],
        "left": wall(rectangle(1, 0., low, high), "free slip"),
        "right": wall(rectangle(1, 0.12, low, high), "yield slip") + LAWS["yield slip"],
        "inlet": wall(rectangle(0, 0., low, (0., 0.12, 0.09)), "inflow") +
        section("inflow", "set Discharge table = discharge.csv", "set Profile = 1 + 4 * y"),
        "outlet": wall(rectangle(0, 0.18, low, high), "outflow") +
        section("outflow", "set Direction = 1, 0, 0", "set Level = 0.09")}
    return HEAD.replace("0.5, 0.3", "0, 0") + until(MIDDLE_OF_INFLOW) + parts("Boundaries", boundaries) + \
        parts("Fluids", {"mud": shape("box", "Corners = 0, 0, 0 : 0.18, 0.12, 0.09") +
                         "set Initial velocity = 0.5; 0; 0\n" + FLUID}) + GAUGES


CASES = {law: box_case(law) for law in LAWS}
CASES["inflow"] = inflow_case()


def run(directory, n_ranks, *arguments):
    command, environment = on_ranks([LAHAR, *arguments, "case.prm"], MPIEXEC, n_ranks)
    return subprocess.run(command, cwd=directory, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True)


def case(parent, name, text):
    directory = new_case(parent, name, text)
    with open(os.path.join(directory, "way.csv"), "w") as file:
        file.write("0, 0, 0, 0\n0.03, 0.001, 0, 0\n0.06, 0.006, 0.002, 0.001\n0.2, 0.03, 0.01, 0.02\n")
    with open(os.path.join(directory, "discharge.csv"), "w") as file:
        file.write("0, 0.0054\n0.05, 0.0054\n0.1, 0.007\n")
    return directory


def results(directory):
    """The statistics but what tells of convergence, and the particles of the last snapshot, in any order."""
    statistics = read_statistics(os.path.join(directory, "out", "statistics"))
    of_convergence = ("increment", "residual", "iterations", "Wall time", "yield gap", "Yield gap")
    columns = {name: values for name, values in statistics.items() if not any(word in name for word in of_convergence)}
    mesh = read_vtu(read_pvd(os.path.join(directory, "out", "solution.pvd"))[-1][1], dimension=3)
    return columns, np.unique(mesh.points, axis=0)


def family(name):
    """What the columns of the components of one vector have in common."""
    return re.sub(r" [xyz] \(", " (", name)


def compare(what, expected, found):
    (columns, points), (other_columns, other_points) = expected, found
    check(what + ": the same columns and steps", list(columns) == list(other_columns) and
          len(columns["Time (s)"]) == len(other_columns["Time (s)"]) > 5)
    differences = []
    for name, values in columns.items():
        # Changes of volume are relative already; components of a vector are measured by its largest one.
        scale = 1. if name.startswith("Volume change") else \
            max(np.abs(columns[other]).max() for other in columns if family(other) == family(name)) or 1.
        differences.append((np.abs(values - other_columns[name]).max() / scale, name))
    check(what + ": the same values", max(differences)[0] <= TOLERANCE, *sorted(differences)[-5:])
    distances = np.linalg.norm(points[:, None, :] - other_points[None, :, :], axis=2)
    farthest = max(distances.min(axis=0).max(), distances.min(axis=1).max())
    check(what + ": the same particles", farthest <= TOLERANCE * MESH_SIZE, farthest)


def test(name):
    with tempfile.TemporaryDirectory() as parent:
        whole = {}
        for n_ranks in RANKS:
            directory = case(parent, f"whole-{n_ranks}", CASES[name])
            process = run(directory, n_ranks)
            check(f"{name}: {n_ranks} ranks", process.returncode == 0, process.stdout[-1000:], process.stderr)
            whole[n_ranks] = results(directory)
            if n_ranks > 1:
                compare(f"{name}: {n_ranks} ranks and 1", whole[1], whole[n_ranks])
        for n_ranks in RANKS:
            directory = case(parent, f"parts-{n_ranks}", CASES[name])
            columns = whole[n_ranks][0]
            middle = MIDDLE_OF_INFLOW if name == "inflow" else MIDDLE
            check(f"{name}: {n_ranks} ranks, a part",
                  run(directory, n_ranks, "--set", f"End time={middle:g}").returncode == 0)
            check(f"{name}: {n_ranks} ranks, the rest", run(directory, n_ranks, "--resume").returncode == 0)
            resumed, points = results(directory)
            differ = [column for column in columns if not np.array_equal(columns[column], resumed[column], equal_nan=True)]
            check(f"{name}: {n_ranks} ranks, resumed: bit for bit", not differ and
                  np.array_equal(points, whole[n_ranks][1]), *differ)


if __name__ == "__main__":
    for group in CASES if sys.argv[1] == "all" else [sys.argv[1]]:
        test(group)
    sys.exit(1 if failed else 0)
