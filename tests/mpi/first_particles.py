#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Test the start of runs of the program `lahar` on several ranks.

same:    `--check` prints the same, and the first snapshot has the same cells, on 1, 2 and 4 ranks.
refused: bodies and walls that overlap are refused on several ranks as on one, with the same message and place.
memory:  of four ranks each has a part of the memory that one rank has, beyond that of the libraries.

Usage: first_particles.py GROUP LAHAR MPIEXEC
"""
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "contrib", "plot"))

import numpy as np  # noqa: E402

from lahar_output import read_pvd, read_vtu  # noqa: E402
from program_test import (barrier, check, failed, fluid, new_case, on_ranks, parts, section, shape,  # noqa: E402
                          wall, walls)

LAHAR, MPIEXEC = os.path.abspath(sys.argv[2]), sys.argv[3]

# With two resolutions.
PLANE = """
set Output directory = out
set End time         = 1e-4
set Time step        = 1e-4
set Mesh size        = 0.01
""" + fluid("0, 0 : 0.146, 0.292") + walls("0, 0.4 : 0, 0 : 0.5, 0") + \
    section("Remeshing", "set Refined boxes = 0.1, 0 : 0.15, 0.05 : 0.003") + \
    section("Linear solver", "set Type = iterative")

FLOOR = walls("-0.15, -0.15, 0 : 0.15, -0.15, 0 : 0.15, 0.15, 0 : -0.15, 0.15, 0")

LAW = "set Law = Bingham\n" + section("Bingham", "set Density = 2252", "set Plastic viscosity = 4",
                                     "set Yield stress = 18")

CONE = """
set Dimension        = 3
set Output directory = out
set End time         = 1e-4
set Time step        = 1e-4
set Mesh size        = 0.005
set Fluids           = fluid
""" + section("Fluids", section("fluid", shape("cone", "Base = 0, 0, 0", "Base radius = 0.05", "Top radius = 0.035",
                                               "Height = 0.05"), LAW)) + FLOOR

REFINED_CONE = CONE + section("Remeshing", "set Refined boxes = 0.03, -0.01, 0 : 0.05, 0.01, 0.01 : 0.0025")

CASES = {"plane": PLANE, "cone": CONE, "refined cone": REFINED_CONE}

TOP = "set End time = 1e-4\nset Time step = 1e-4\nset Mesh size = 0.02\n"


def two(kind, a, b):
    return parts(kind, {"a": a, "b": b})


# Each overlap has many points, which several ranks find.
REFUSED = {
    "fluids": ("Fluid 'a' overlaps fluid 'b' at",
               two("Fluids", shape("box", "Corners = 0, 0 : 0.4, 0.2"), shape("box", "Corners = 0.05, 0.1 : 0.5, 0.3"))),
    "a closed line": ("overlaps boundary 'walls' at", fluid("0, 0 : 0.4, 0.2") + walls(
        "-0.1, -0.1 : 0.3, -0.1 : 0.3, 0.4 : -0.1, 0.4 : -0.1, -0.1")),
    "two boundaries": ("lie on each other at (0.", fluid("0, 0 : 0.4, 0.2") + two(
        "Boundaries", wall("-0.1, 0 : 0.5, 0"), wall("0.02, 0 : 0.4, 0", "free slip"))),
    "a solid": ("Fluid 'fluid' overlaps a solid at", fluid("0, 0 : 0.4, 0.2") + barrier(0.1, 0.35)),
    "no room": ("No fluid particle is left", fluid("0, 0 : 0.4, 0.02") + two(
        "Boundaries", *(wall(f"-0.1, {y} : 0.5, {y}", "wall particles") for y in (0, 0.02)))),
}

RANKS = (1, 2, 4)

# Run a program and write its largest memory (kB) into a file of this rank.
MEASURE = """
import os, resource, subprocess, sys
status = subprocess.call(sys.argv[1:])
rank = os.environ.get("OMPI_COMM_WORLD_RANK", os.environ.get("PMI_RANK", "0"))
with open("memory-" + rank, "w") as file:
    file.write(str(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss))
sys.exit(status)
"""


def run(directory, n_ranks, *program, status=0):
    command, environment = on_ranks(list(program), MPIEXEC, n_ranks)
    result = subprocess.run(command, cwd=directory, env=environment, stdin=subprocess.DEVNULL, capture_output=True,
                            text=True, timeout=800)
    check(f"{os.path.basename(directory)}: status", result.returncode == status, result.stdout, result.stderr)
    return result


def cells(directory):
    """The cells of the first snapshot by their corners, in an order that depends on these only."""
    dimension = 3 if "cone" in os.path.basename(directory) else 2
    mesh = read_vtu(read_pvd(os.path.join(directory, "out", "solution.pvd"))[0][1], dimension)
    corners = mesh.points[mesh.cells]
    for axis in reversed(range(corners.shape[2])):  # the last key of a stable sort counts most
        order = np.argsort(corners[:, :, axis], axis=1, kind="stable")
        corners = np.take_along_axis(corners, order[:, :, None], axis=1)
    table = corners.reshape(len(corners), -1)
    return table[np.lexsort(table.T)]


def same():
    with tempfile.TemporaryDirectory() as parent:
        for name, text in CASES.items():
            printed, meshes = {}, {}
            for n_ranks in RANKS:
                directory = new_case(parent, f"{name} on {n_ranks}", text)
                printed[n_ranks] = run(directory, n_ranks, LAHAR, "--check", "case.prm").stdout
                run(directory, n_ranks, LAHAR, "case.prm")
                meshes[n_ranks] = cells(directory)
            check(f"{name}: it has cells", len(meshes[1]) > 100, len(meshes[1]))
            for n_ranks in RANKS[1:]:
                check(f"{name}: --check prints the same on {n_ranks}", printed[n_ranks] == printed[1], printed[1],
                      printed[n_ranks])
                check(f"{name}: the same first mesh on {n_ranks}", np.array_equal(meshes[n_ranks], meshes[1]))


def refused():
    with tempfile.TemporaryDirectory() as parent:
        for name, (message, text) in REFUSED.items():
            said = {}
            for n_ranks in RANKS:
                directory = new_case(parent, f"{name} on {n_ranks}", TOP + text)
                errors = run(directory, n_ranks, LAHAR, "--check", "case.prm", status=2).stderr
                said[n_ranks] = [line for line in errors.splitlines() if message in line]
            check(f"{name}: refused", len(said[1]) == 1, errors)
            for n_ranks in RANKS[1:]:
                check(f"{name}: with the same message on {n_ranks}", said[n_ranks] == said[1], said, errors)


def memory():
    with tempfile.TemporaryDirectory() as parent:
        def largest(name, n_ranks, mesh_size):
            """Of the ranks, in MiB."""
            directory = new_case(parent, name, CONE)
            run(directory, n_ranks, sys.executable, "-c", MEASURE, LAHAR, "--check", "--set", f"Mesh size={mesh_size}",
                "case.prm")
            return max(float(open(os.path.join(directory, f"memory-{rank}")).read()) for rank in range(n_ranks)) / 1024

        # Of this size, four ranks know 0.4 to 0.5 of the particles each: what is around their own.
        whole, part = (largest(f"{n} ranks", n, 0.0018) - largest(f"{n} ranks, little", n, 0.012) for n in (1, 4))
        check("memory: the case is large enough to tell", whole > 100., whole)
        check("memory: four ranks have a part of it each", part < 0.7 * whole, f"{part} and {whole} MiB")


{"same": same, "refused": refused, "memory": memory}[sys.argv[1]]()
sys.exit(1 if failed else 0)
