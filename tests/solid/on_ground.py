#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Test an elastic barrier that stands on rough ground in the way of a debris flow: its foot follows the ground and stays,
its weight is that of the drawing, in space, on sharp ridges too, and in the plane; forces and momentum balance, volume is
kept; a resumed run is the same bit for bit, one on two ranks to 1e-8; ground that is not there is refused.

Usage: on_ground.py LAHAR MPIEXEC
"""
import math
import os
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "contrib", "plot"))

from lahar_output import read_statistics  # noqa: E402
from program_test import check, failed, new_case, on_ranks, parts, section, shape  # noqa: E402

LAHAR, MPIEXEC = os.path.abspath(sys.argv[1]), sys.argv[2]

STEP = 0.01
SOLID_DENSITY = 2400.


def elevation(x, y):
    """A slope of 1 : 2 with bumps about a metre long."""
    return 10. - 0.5 * x + 0.15 * math.sin(2.9 * x + 1.) * math.sin(2.3 * y) + 0.1 * math.sin(4.7 * y + x)


def write_ground(directory):
    with open(os.path.join(directory, "ground.asc"), "w") as file:
        file.write("ncols 25\nnrows 17\nxllcenter 0\nyllcenter 0\ncellsize 0.5\nNODATA_value -9999\n")
        for row in range(16, -1, -1):
            file.write(" ".join(f"{elevation(0.5 * column, 0.5 * row):.4f}" for column in range(25)) + "\n")


def write_ridges(directory):
    """Elevations in steps of a twentieth of their distance, as those of a map: sharp ridges along the cells' diagonals."""
    steps = [[110, 110, 115, 120], [110, 111, 118, 120], [111, 115, 117, 120], [115, 116, 118, 121], [117, 118, 120, 122]]
    with open(os.path.join(directory, "ridges.asc"), "w") as file:
        file.write("ncols 4\nnrows 5\nxllcenter 0\nyllcenter 0\ncellsize 0.5\nNODATA_value -9999\n")
        for row in steps:
            file.write(" ".join(f"{0.05 * value:.2f}" for value in row) + "\n")


def solid(corners, clamped, ground="ground", elements="1, 10, 4"):
    return shape("box", f"Corners = {corners}", f"Elements = {elements}") + f"set Ground = {ground}\nset Clamped = {clamped}\n" + \
        "set Law = hypoelastic\n" + section("hypoelastic", f"set Density = {SOLID_DENSITY:g}", "set Young's modulus = 2e8",
                                            "set Poisson's ratio = 0.2")


CASE = f"""
set Dimension         = 3
set Output directory  = out
set End time          = 0.24
set Time step         = {STEP:g}
set Maximum time step = {STEP:g}
set Mesh size         = 0.5
set Output interval   = 0.1
set Gravity           = 0, 0, -9.81
""" + parts("Boundaries", {"ground": shape("terrain", "File = ground.asc", "Spacing = 0.5") + "set Law = Navier slip\n" +
                           section("Navier slip", "set Slip coefficient = 500")}) + \
    parts("Fluids", {"debris": shape("release", "Boundary = ground", "Depth = 1.2",
                                     "Outline = 2, 2 : 4.5, 2 : 4.5, 6 : 2, 6") + "set Initial velocity = 4; 0; -2\n" +
                     "set Law = Bingham\n" + section("Bingham", "set Density = 1800", "set Plastic viscosity = 100",
                                                     "set Yield stress = 200")}) + \
    parts("Solids", {"barrier": solid("5, 1.5, 0 : 5.5, 6.5, 2", "0, 0, 0 : 12, 8, 0")}) + \
    section("Nonlinear solver", "set Tolerance = 2e-5") + \
    section("Linear solver", section("Iterative", "set Tolerance = 1e-8"))


def run(directory, *arguments, n_ranks=1):
    command, environment = on_ranks([LAHAR, *arguments, "case.prm"], MPIEXEC, n_ranks)
    return subprocess.run(command, cwd=directory, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True)


def case(parent, name, text):
    directory = new_case(parent, name, text)
    write_ground(directory)
    return directory


def statistics(directory):
    return read_statistics(os.path.join(directory, "out", "statistics"))


def test_flow(parent):
    """The debris reaches the barrier, and is held."""
    whole = case(parent, "whole", CASE)
    process = run(whole)
    check("the run succeeds", process.returncode == 0, process.stdout[-500:], process.stderr)
    s = statistics(whole)
    weight = SOLID_DENSITY * 9.81 * 0.5 * 5. * 2.
    pushed = s["barrier fluid force x (N)"].max()
    check("the debris pushes the barrier downhill", pushed > 0.05 * weight, pushed, weight)
    check("volume change by the solver", np.abs(s["Volume change by solver"]).max() < 1e-6)
    check("volume change by remeshing", np.abs(s["Volume change by remeshing"]).max() < 0.02,
          s["Volume change by remeshing"][-1])

    # Momentum (doc/forces.md).
    lacks, impulses = [], []
    dt = s["Time step size (s)"]
    mass = 1800. * s["Fluid volume (m^dim)"]
    for axis, gravity in [("x", 0.), ("y", 0.), ("z", -9.81)]:
        momentum = s[f"Momentum {axis} (N s)"]
        on_walls = s[f"ground force {axis} (N)"] + s[f"barrier fluid force {axis} (N)"]
        changes = sum(s[f"Momentum change by {cause} {axis} (N s)"] for cause in ("solver", "remeshing", "lag"))
        lack = momentum - np.cumsum((mass * gravity - on_walls) * dt) - changes
        lacks.append(lack - lack[0])
        impulses.append((mass * gravity - on_walls) * dt)
    lacks, impulses = (np.linalg.norm(vectors, axis=0) for vectors in (lacks, impulses))
    check("balance of momentum", lacks.max() < 0.1 * impulses.max(), lacks.max(), impulses.max())

    parts_of = case(parent, "parts", CASE)
    check("the first part succeeds", run(parts_of, "--set", "End time=0.1").returncode == 0)
    check("the second part succeeds", run(parts_of, "--resume").returncode == 0)
    resumed = statistics(parts_of)
    check("the resumed run is the same bit for bit",
          all(np.array_equal(s[name], resumed[name]) for name in s if name != "Wall time (s)"))


def test_weight(parent):
    """A barrier without fluid: its foot bears the weight of the drawing, since raising it is a shear."""
    head = f"""
set Output directory = out
set End time         = {30 * STEP:g}
set Time step        = {STEP:g}
set Mesh size        = 0.5
"""
    ground = parts("Boundaries", {"ground": shape("terrain", "File = ground.asc") + "set Law = no slip\n"})
    bed = parts("Boundaries", {"bed": shape("terrain", "File = profile.csv") + "set Law = no slip\n"})
    # The ground's ridges pass through the barrier's sides a little above its foot.
    ridges = ground.replace("ground.asc", "ridges.asc")
    for name, text, column, volume in [
            ("space", "set Dimension = 3\n" + head + ground +
             parts("Solids", {"barrier": solid("5, 1.5, 0 : 5.5, 6.5, 2", "0, 0, 0 : 12, 8, 0")}),
             "barrier support force z (N)", 0.5 * 5. * 2.),
            ("ridges", ("set Dimension = 3\n" + head + ridges).replace("Mesh size        = 0.5", "Mesh size        = 0.25") +
             parts("Solids", {"barrier": solid("0.5, 0.25, 0 : 0.8, 1.75, 0.6", "0, 0, 0 : 2, 2, 0", elements="1, 6, 2")}),
             "barrier support force z (N)", 0.3 * 1.5 * 0.6),
            ("plane", head + bed + parts("Solids", {"wall": solid("6, 0 : 7, 2", "0, 0 : 12, 0", "bed").replace(
                "1, 10, 4", "4, 6")}), "wall support force y (N)", 2.)]:
        directory = case(parent, "weight_" + name, text.replace("2e8", "2e10"))
        write_ridges(directory)
        with open(os.path.join(directory, "profile.csv"), "w") as file:
            file.writelines(f"{0.4 * k}, {5. - 0.2 * k + 0.1 * math.sin(3. * k)}\n" for k in range(31))
        process = run(directory)
        check(f"{name}: the run succeeds", process.returncode == 0, process.stdout[-500:], process.stderr)
        support = statistics(directory)[column] / (SOLID_DENSITY * 9.81 * volume)
        check(f"{name}: the foot bears the weight", abs(support[-1] - 1.) < 0.01, support)


def test_ranks(parent):
    """Two ranks compute the same until the debris is at the barrier."""
    text = CASE.replace("set Tolerance = 2e-5", "set Tolerance = 1e-9").replace(
        "subsection Linear solver\n", "subsection Linear solver\n  set Type = direct\n" +
        section("Direct", "set Package = KLU", "set Tolerance = 0"))
    results = []
    for n_ranks in (1, 2):
        directory = case(parent, f"ranks_{n_ranks}", text)
        process = run(directory, "--set", f"End time={8 * STEP:g}", n_ranks=n_ranks)
        check(f"{n_ranks} ranks", process.returncode == 0, process.stdout[-500:], process.stderr)
        results.append(statistics(directory))
    alone, shared = results
    for name in ("Fluid volume (m^dim)", "Kinetic energy (J)", "Momentum change by remeshing x (N s)", "ground force x (N)",
                 "barrier fluid force x (N)"):
        difference = np.abs(alone[name] - shared[name]).max() / np.abs(alone[name]).max()
        check(f"two ranks and one: {name}", difference < 1e-8, difference)


def test_refused(parent):
    for name, old, new, words in [
            ("no such ground", "set Ground = ground", "set Ground = hill", ["Solids/barrier/Ground", "'hill'", "'ground'"]),
            ("beside the ground", "5.5, 6.5, 2", "5.5, 9.5, 2", ["Solids/barrier/Ground", "'barrier'", "(5 8.3 0)"])]:
        process = run(case(parent, "refused_" + name.replace(" ", "_"), CASE.replace(old, new)))
        check(f"refused: {name}", process.returncode == 2 and all(word in process.stderr for word in words),
              process.returncode, process.stderr)


with tempfile.TemporaryDirectory() as parent_directory:
    test_refused(parent_directory)
    test_weight(parent_directory)
    test_flow(parent_directory)
    test_ranks(parent_directory)
sys.exit(1 if failed else 0)
