#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Test the program `lahar` from outside, each run in a directory of its own.

refused:  wrong input ends with status 2; the message names the parameter by its path, the value found and what is
          allowed; it shows no C++ or deal.II frame, and nothing is left behind.
printed:  --help, --version, --print-parameters, --check end with status 0.
computed: a small run leaves complete, readable files; so does one that fails, with status 1.

Usage: bad_input.py refused|printed|computed LAHAR MESH_FILE MESH_FILE_IN_SPACE
"""
import glob
import json
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

from program_test import check, failed, fluid, parts, section, shape, wall, walls  # noqa: E402

LAHAR, MESH, MESH_IN_SPACE = [os.path.abspath(path) for path in sys.argv[2:5]]

TOP = """
set Output directory = out
set End time         = 4e-3
set Time step        = 1e-3
set Mesh size        = 0.03
set Output interval  = 2e-3
"""
COLUMN = fluid("0, 0 : 0.146, 0.292")
GOOD = TOP + COLUMN + walls("0, 0.4 : 0, 0 : 0.5, 0")

# What the entries of fluid and walls begin with.
FLUID, WALLS = "Fluids/fluid/", "Boundaries/walls/"

COLUMNS = ["Time step number", "Time (s)", "Time step size (s)", "Nonlinear iterations", "Velocity increment",
           "Pressure increment", "Linear iterations", "Held vertices", "Fluid cells", "Solid cells", "Fluid particles",
           "Fluid volume (m^dim)", "Volume change by solver", "Volume change by remeshing", "Remeshed",
           "Kinetic energy (J)", "Wall time (s)"]

FRAMES = ["Stacktrace", "An error occurred in line", "terminate called", "Aborting", "exception", "Exception",
          "std::", "Lahar::", "dealii::", "Backtrace", "Segmentation", "parameter_handler.cc"]

def run(directory, *arguments, text=GOOD):
    if text is not None:
        with open(os.path.join(directory, "case.prm"), "w", encoding="utf-8") as file:
            file.write(text)
    environment = dict(os.environ, OMP_NUM_THREADS="1", DEAL_II_NUM_THREADS="1")
    try:
        return subprocess.run([LAHAR, *arguments], cwd=directory, env=environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=300, text=True)
    except subprocess.TimeoutExpired:
        return subprocess.CompletedProcess(arguments, 124, "", "no end within 300 s")


def refused(what, parts, *arguments, text=GOOD, case="case.prm", prepare=None):
    """The run must end with status 2, a message that holds all parts, and leave nothing."""
    with tempfile.TemporaryDirectory() as directory:
        if prepare:
            prepare(directory)
        before = sorted(os.listdir(directory) + (["case.prm"] if text is not None else []))
        result = run(directory, *([case] if case else []), *arguments, text=text)
        after = sorted(os.listdir(directory))
        message = result.stderr
        check(what + ": status 2", result.returncode == 2, result.returncode, message)
        missing = [part for part in parts if part not in message]
        check(what + ": message", message.strip() and not missing, "missing: %s" % missing, message)
        frames = [frame for frame in FRAMES if frame in message + result.stdout]
        check(what + ": no frame", not frames and message.count("\n") <= 6, frames, message)
        check(what + ": nothing left behind", before == after, after)


def set_entry(entry, value):
    return ["--set", "%s=%s" % (entry, value)]


def wrong(entry, value, *parts, more=()):
    """A wrong value of one entry, given by --set, must be named by its path."""
    refused("%s = %s" % (entry, value), ["'%s'" % entry, value, "llowed", *parts], *more, *set_entry(entry, value))


def write_spike(directory):
    """The mesh in space with one corner far away: little volume in a box of 10^8 cubes of the mesh size."""
    with open(MESH_IN_SPACE) as mesh, open(os.path.join(directory, "spike.msh"), "w") as spike:
        spike.write(mesh.read().replace("\n1 0 0 0\n", "\n1 -1500 -325 -324\n", 1))


def in_spike():
    return [*set_entry("Mesh size", "0.9"), *set_entry(FLUID + "Shape", "mesh"), *set_entry(FLUID + "mesh/File", "spike.msh"),
            *set_entry(FLUID + "mesh/Groups", "fluid")]


def test_refused():
    in_space = TOP + "set Dimension = 3\n" + fluid("0, 0, 0 : 1, 1, 1")
    cone = {"Base": "0, 0, 0", "Base radius": "0.05", "Top radius": "0.03", "Height": "0.1"}
    cylinder = {"Ends": "0, 0, 0 : 0, 0, 1", "Radius": "0.1"}
    for kind, good, bad in [("cone", cone, [("Top radius", "0.06"), ("Top radius", "-0.01"), ("Height", "0"),
                                            ("Base radius", "0"), ("Base", "0, 0")]),
                            ("cylinder", cylinder, [("Ends", "0, 0, 0 : 0, 0, 0"), ("Ends", "0, 0 : 0, 1"),
                                                    ("Ends", "0, 0, 0"), ("Radius", "-0.1"), ("Radius", "")])]:
        for entry, value in bad:
            refused("%s, %s = %s" % (kind, entry, value), ["'%s%s/%s'" % (FLUID, kind, entry), value, "llowed"],
                    *set_entry(FLUID + "Shape", kind), *(word for item in dict(good, **{entry: value}).items()
                                                         for word in set_entry(FLUID + kind + "/" + item[0], item[1])),
                    text=in_space)

    def mesh(part, file, groups):
        """Settings for the shape of a part."""
        return [*set_entry(part + "Shape", "mesh"), *set_entry(part + "mesh/File", file),
                *set_entry(part + "mesh/Groups", groups)]

    tank = in_space + walls("0, 0, 0 : 1, 0, 0 : 1, 1, 0")
    refused("a mesh of the plane in space", [MESH, "physical volume 'fluid'", "plane", "'Dimension' is 3"],
            *mesh(FLUID, MESH, "fluid"), text=in_space)
    refused("unknown fluid volume", [MESH_IN_SPACE, "'water'", "'fluid'", "'block'"],
            *mesh(FLUID, MESH_IN_SPACE, "water"), text=in_space)
    refused("unknown wall surface", [MESH_IN_SPACE, "'roof'", "'floor'", "'left wall'"],
            *mesh(WALLS, MESH_IN_SPACE, "roof"), text=tank)
    refused("groups without a file in space", ["'Fluids/fluid/mesh/File'", "gmsh", "llowed"],
            *mesh(FLUID, "", "fluid"), text=in_space)
    refused("unknown group of a solid in space", [MESH_IN_SPACE, "physical volume 'wood'", "'block'"],
            "--set", "Solids=block", *mesh("Solids/block/", MESH_IN_SPACE, "wood"), text=in_space)
    refused("a mesh in space in the plane", [MESH_IN_SPACE + ":", "z = 0", "'Dimension' is 2"],
            *mesh(FLUID, MESH_IN_SPACE, "fluid"))

    wrong("Postprocess/Fluid extents/Boxes", "tip: 0, 0 : 1, 1", "Extents", "tip")
    wrong("Postprocess/Fluid extents/Boxes", "front: 0, 0", "x, y : x, y")
    wrong("Postprocess/Fluid extents/Smallest part", "0", "1 to 1000000000")
    for entry, value in [("Dimension", "4"), ("Dimension", "two"), ("Remeshing/Keep volume", "yes"), ("Mesh size", "0"), ("Mesh size", "-0.01"),
                         ("Mesh size", "small"), ("Mesh size", "nan"), ("Time step", "0"), ("Time step", "1e-3 s"),
                         ("Time step", "inf"), ("End time", "0"), ("End time", "-1"), ("Minimum time step", "1"),
                         ("Maximum time step", "1e-4"), ("Maximum time step", "-1"),
                         ("Largest movement", "0"), ("Remeshing/Domain", "0, 0 : 0.1, 0.1"), ("Remeshing/Domain", "0, 0"),
                         ("Remeshing/Refined boxes", "0, 0 : 0.1, 0.1"), ("Remeshing/Refined boxes", "0, 0 : 0.1, 0.1 : 1"), ("Remeshing/Refined boxes", "0, 0 : 0, 0.1 : 1e-3"),
                         ("Checkpoint/Steps between", "0.5"), ("Checkpoint/Minutes between", "-1"),
                         ("Output interval", "-1"), ("Gravity", "0"), ("Gravity", "0, down"), ("Gravity", "0, 0, -9.81"),
                         (FLUID + "Initial velocity", "1"), (FLUID + "Initial velocity", "1; q"),
                         (FLUID + "Initial velocity", "1; (x"),
                         (FLUID + "Bingham/Density", "-1000"), (FLUID + "Bingham/Density", "0"),
                         (FLUID + "Bingham/Plastic viscosity", "-1"), (FLUID + "Bingham/Plastic viscosity", "thick"),
                         (FLUID + "Bingham/Yield stress", "-1"), (FLUID + "Bingham/Regularization parameter", "0"),
                         (FLUID + "Bingham/Bulk modulus", "-1"), (FLUID + "Bingham/Bulk modulus", "soft"),
                         ("Remeshing/Alpha shape/Alpha", "0.9"), ("Remeshing/Alpha shape/Alpha", "1,25"),
                         ("Remeshing/Alpha shape/Alpha inside", "1"), ("Remeshing/Particle spacing/Shortest edge", "1"),
                         ("Nonlinear solver/Tolerance", "0"), ("Nonlinear solver/Maximum iterations", "0"),
                         ("Nonlinear solver/Maximum iterations", "2.5"), ("Stabilization/Viscosity limit", "-1")]:
        wrong(entry, value)
    wrong("Time step", "1e-13", "1e-12", "End time", more=set_entry("End time", "1"))
    wrong("Minimum time step", "1e-30", "1e-14")
    wrong("Output interval", "1e-20", "1e-9")
    wrong(FLUID + "Initial velocity", "1 / (x - x); 0", "finite")
    wrong("End time", "1", "Start time", more=set_entry("Start time", "2"))

    # A misspelt model: the valid names are listed.
    wrong(FLUID + "Law", "Binghamm", "Bingham", "Newtonian")
    wrong(FLUID + "Shape", "sphere", "box", "mesh", "polygon")
    wrong(WALLS + "Shape", "plane", "mesh", "polyline")
    wrong(WALLS + "Law", "slip", "free slip", "no slip")
    wrong("Nonlinear solver/Scheme", "coupling", "coupled", "segregated")
    wrong("Nonlinear solver/Viscosity linearization", "quasi", "picard", "newton", "primal-dual")
    wrong("Stabilization/Form", "fic", "FIC", "residual")
    wrong("Postprocess/Fields", "velocity, temperature", "pressure", "yielded", "commas")
    wrong("Remeshing/Alpha shape/Rule", "alpha", "plain", "advected")
    wrong("Linear solver/Direct/Package", "Pardiso", "MUMPS", "KLU")
    wrong("Linear solver/Type", "multigrid", "direct", "iterative")
    wrong("Linear solver/Iterative/Preconditioner", "AMG", "ML", "ILU")
    wrong("Linear solver/Iterative/Tolerance", "0.5", "0.1")
    wrong("Linear solver/Iterative/Maximum iterations", "0")
    wrong("Time integration", "RK4", "Newmark", "backward Euler")

    # Fluids and boundaries.
    corners, points = FLUID + "box/Corners", WALLS + "polyline/Points"
    wrong(corners, "0, 0 : 1, one", "x, y : x, y")
    wrong(corners, "0, 0 : 1", "x, y : x, y")
    wrong(corners, "0, 0 : 0, 1", "opposite corners")
    wrong(corners, "", "opposite corners")
    wrong(FLUID + "polygon/Corners", "0, 0 : 1, 1 : 1, 0 : 0, 1", "three corners", more=set_entry(FLUID + "Shape", "polygon"))
    wrong(FLUID + "polygon/Corners", "", "three corners", more=set_entry(FLUID + "Shape", "polygon"))
    wrong(points, "0, 0", "two different points")
    wrong(points, "", "two different points")
    for entry, value in [("convex", "0, 0, 0 : 1, 0, 0 : 0, 1, 0 : 1, 1, 0"), ("convex", "")]:
        refused("%s = %s" % (entry, value), ["'%s%s/Corners'" % (FLUID, entry), value, "llowed"], *set_entry(
            FLUID + "Shape", entry), *set_entry(FLUID + entry + "/Corners", value), text=in_space)
    for value in ("0, 0, 0 : 1, 0, 0", "0, 0, 0 : 1, 0, 0 : 1, 1, 0 : 0, 1, 0.1", ""):
        refused("polygon " + value, ["'%spolygon/Corners'" % WALLS, value, "llowed"],
                *set_entry(WALLS + "polygon/Corners", value), text=tank)
    refused("no fluid and no solid", ["'Fluids' and 'Solids' are empty", "Allowed", "'set Fluids = NAME'"], text=TOP)
    refused("mesh size above the body", ["'Mesh size'", "0.2", "0.146", "Allowed"], *set_entry("Mesh size", "0.2"))
    refused("fluid over a wall", ["Fluid 'fluid' overlaps boundary 'walls' at"], *set_entry(points, "0.05, -1 : 0.05, 1"))
    refused("fluid over the second wall", ["Fluid 'fluid' overlaps boundary number 2 of 'walls' at"],
            *set_entry(points, "0, 0.4 : 0, 0 : 0.5, 0; 0.05, -1 : 0.05, 1"))
    refused("overlapping bodies", ["Fluid 'fluid' (number ", "overlaps fluid 'fluid' (number "],
            *set_entry(corners, "0, 0 : 0.2, 0.2; 0.1, 0.1 : 0.3, 0.3"))
    refused("missing gmsh file", ["nowhere.msh", "does not exist"], *mesh(FLUID, "nowhere.msh", "fluid"))
    refused("unknown gmsh group", ["'roof'", "'floor'", "'left wall'"], *mesh(WALLS, MESH, "roof"))
    refused("unknown fluid group", ["'water'", "'fluid'"], *mesh(FLUID, MESH, "water"))
    refused("groups without a file", ["'Fluids/fluid/mesh/File'", "gmsh", "llowed"], *mesh(FLUID, "", "fluid"))
    refused("a file without groups", ["'Boundaries/walls/mesh/Groups'", "physical groups", "llowed"], *mesh(WALLS, MESH, ""))
    refused("a mesh file that is none", ["case.prm:", "$MeshFormat"], *mesh(FLUID, "case.prm", "fluid"))

    # What would need too much memory.
    refused("too many particles", ["'Mesh size'", "1e-09", "fluid 'fluid'", "Largest number of particles", "10000000"],
            *set_entry("Mesh size", "1e-9"))
    refused("walls of too many particles", ["'Mesh size'", "boundary 'walls'", "Largest number of particles"],
            *set_entry(points, "0, 0.4 : 0, 0 : 1e30, 0"))
    refused("more particles than set", ["'Mesh size'", "fluid 'fluid'", "which is 10,"],
            *set_entry("Largest number of particles", "10"))
    wrong("Largest number of particles", "1e9")
    refused("too many particles in space", ["'Mesh size'", "fluid 'fluid'", "Largest number of particles"],
            *set_entry("Mesh size", "1e-3"), text=in_space)
    refused("a polyhedron of too many corners", ["'Fluids/fluid/convex/Corners'", "at most 100"],
            *set_entry(FLUID + "Shape", "convex"), *set_entry(FLUID + "convex/Corners", " : ".join("%d, %d, %d" % (i, i * i, i**3) for i in range(101))), text=in_space)
    refused("a mesh with a spike of too many particles", ["'Mesh size'", "fluid 'fluid'", "Largest number of particles"],
            *in_spike(), *set_entry("Largest number of particles", "1000"), text=in_space, prepare=write_spike)

    # Solids.
    def solid(corners, *settings):
        """Settings for a case with a solid 'beam'; its own begin with S/."""
        return [word for setting in ("Solids=beam", "S/Shape=box", "S/box/Corners=" + corners, *settings)
                for word in ("--set", setting.replace("S/", "Solids/beam/"))]

    beside = "0.2, 0 : 0.25, 0.1"
    wrong("Solids/Degree", "3")
    wrong("Solids/beam/hypoelastic/Poisson's ratio", "0.5", "below 0.5", more=solid(beside))
    wrong("Solids/beam/hypoelastic/Young's modulus", "-1", more=solid(beside))
    wrong("Solids/beam/Law", "rubber", "hypoelastic", "neo-Hookean", more=solid(beside))
    wrong("Solids/beam/Shape", "ball", "box", "mesh", more=solid(beside))
    wrong("Solids/beam/box/Elements", "2, 0", "2 whole numbers", more=solid(beside))
    wrong("Solids/beam/box/Corners", "0, 0 : 0, 1", "differ in every coordinate", more=solid(beside))
    wrong("Solids/beam/Clamped", "1, 1 : 1, 2", "no part of the contour of solid 'beam'", more=solid(beside))
    wrong("Solids/beam/Traction", "1", "functions", more=solid(beside))
    refused("a solid of too many nodes", ["'beam'", "Solids/Largest number of nodes", "1000000", "Elements"],
            *solid(beside, "S/box/Elements=10000, 10000"))
    refused("solid without corners", ["'Solids/beam/box/Corners'", "''", "llowed"], *solid(""))
    refused("solid over the fluid", ["Fluid 'fluid' overlaps a solid"], *solid("0.1, 0 : 0.25, 0.1"))
    refused("fluid over a whole solid", ["Fluid 'fluid' overlaps a solid"], *solid("0.05, 0.05 : 0.1, 0.1"))
    refused("wall through a solid", ["Boundary 'walls' overlaps a solid"], *solid("0.2, -0.1 : 0.25, 0.1"))
    refused("solids that touch", ["Solid 'left' touches solid 'right'", "Allowed"], text=GOOD + parts("Solids", {
        "left": shape("box", "Corners = 0.2, 0 : 0.25, 0.1"), "right": shape("box", "Corners = 0.25, 0 : 0.3, 0.1")}))
    refused("missing mesh of a solid", ["nowhere.msh"], "--set", "Solids=beam", *mesh("Solids/beam/", "nowhere.msh", "fluid"))
    refused("unknown group of a solid", ["'wood'", "'fluid'"], "--set", "Solids=beam", *mesh("Solids/beam/", MESH, "wood"))
    refused("a solid of two groups", ["'Solids/beam/mesh/Groups'", "left, right", "one group"], "--set", "Solids=beam",
            *mesh("Solids/beam/", MESH, "left, right"))
    refused("two columns of one name", ["'walls force x (N)'", "Allowed: different names"],
            *set_entry("Postprocess/Wall forces/Boxes", "walls: -1, -1 : 1, 1"))
    refused("gauge outside the solids", ["Postprocess/Solid points/Points", "tip", "Allowed"], *solid(beside), "--set",
            "Postprocess/Solid points/Points=tip: 0.5, 0.5")

    test_names()
    test_old_entries()

    # The parameter file.
    refused("unknown entry", ["case.prm", "Density of states"], text=GOOD + "set Density of states = 1\n")
    refused("unknown subsection", ["case.prm", "Liquids"], text=GOOD + "subsection Liquids\nend\n")
    refused("open subsection", ["case.prm"], text=GOOD + "subsection Fluids\n")
    refused("a line of nonsense", ["case.prm", "density 1000"], text=GOOD + "density 1000\n")
    refused("a wrong value in the file", ["'Fluids/fluid/Bingham/Density'", "heavy", "llowed"],
            text=GOOD + section("Fluids", section("fluid", section("Bingham", "set Density = heavy"))))
    refused("a file that includes itself", ["include each other", "llowed"], text=GOOD + "include case.prm\n")
    refused("a long line of nonsense", ["case.prm", "xxx", "..."], text=GOOD + 10000 * "x" + "\n")
    refused("empty parameter file", ["no fluid", "'Fluids' and 'Solids' are empty"], text="")
    refused("missing parameter file", ["missing.prm"], text=None, case="missing.prm")
    refused("a directory as parameter file", ["'.'"], text=None, case=".")
    if os.geteuid() != 0:
        def make_unreadable(directory):
            with open(os.path.join(directory, "secret.prm"), "w") as file:
                file.write(GOOD)
            os.chmod(os.path.join(directory, "secret.prm"), 0)
        refused("unreadable parameter file", ["secret.prm"], text=None, case="secret.prm", prepare=make_unreadable)

    # The command line.
    refused("no case", ["--help"], case=None)
    refused("two cases", ["2", "--help"], "other.prm")
    refused("unknown option", ["--fast"], "--fast")
    refused("--set of an unknown entry", ["Fluids/fluid/Densities", "--print-parameters"],
            *set_entry("Fluids/fluid/Densities", "1"))
    refused("--set in an unknown subsection", ["Liquid/Density"], *set_entry("Liquid/Density", "1"))
    refused("--set without a value", ["Time step", "Section/Subsection/Entry=value"], "--set", "Time step")
    refused("--set of nothing", ["Section/Subsection/Entry=value"], "--set", "=1")
    refused("--set without argument", ["set"], "--set")
    refused("unknown format", ["xml", "prm, json, latex"], "--print-parameters", "xml")

    # A path below a regular file cannot be created, whoever asks.
    wrong("Output directory", "case.prm/out")
    wrong("Output directory", "")


def test_names():
    """The names of a case's parts."""
    again = section("Fluids", section("fluid", shape("box", "Corners = 0.2, 0 : 0.3, 0.1")))
    n_lines = GOOD.count("\n")
    for kind in ("Fluids", "Boundaries", "Solids"):
        refused("a name twice in " + kind, ["case.prm:%d: '%s' has the name 'a' twice" % (n_lines + 1, kind), "Allowed"],
                text=GOOD + "set %s = a, b, a\n" % kind)
        for name in ("a/b", "a:b", "a;b", "a'b", "a=b"):
            refused("the name %s in %s" % (name, kind), ["case.prm:%d: '%s' has the name" % (n_lines + 1, kind),
                                                         name[0] + name[1], "Allowed: names of letters, digits"],
                    text=GOOD + "set %s = a, %s\n" % (kind, name))
        refused("an empty name in " + kind, ["'%s' has the name ''" % kind, "Allowed"], *set_entry(kind, "a, , b"))
        refused("a long name in " + kind, ["'%s' has the name" % kind, "at most 60 long"], *set_entry(kind, 61 * "a"))
        refused("a name that is not in " + kind, ["case.prm:%d: there is no subsection '%s/other'" % (n_lines + 2, kind),
                                                  "'other' is not in 'set %s = " % kind, "Allowed"],
                text=GOOD + section(kind, section("other", "set Shape = box")))
        refused("an entry of a name that is not in " + kind, ["--set: there is no entry '%s/other/Shape'" % kind,
                                                              "'other' is not in 'set %s = " % kind, "Allowed"],
                *set_entry(kind + "/other/Shape", "box"))
        refused("a part without a shape in " + kind, ["'%s/part/Shape'" % kind, "''", "Allowed: ", "mesh"],
                text=TOP + COLUMN + parts(kind, {"part": ""}) if kind != "Fluids" else TOP + parts(kind, {"part": ""}))
        refused("a part without its subsection in " + kind, ["'%s/part/Shape'" % kind, "''", "Allowed: ", "mesh"],
                text=(TOP + COLUMN if kind != "Fluids" else TOP) + "set %s = part\n" % kind)
    refused("a name of the list that was there before", ["'Fluids/fluid'", "'set Fluids = water'"],
            text=TOP + COLUMN + "set Fluids = water\n")
    refused("a list behind its subsections", ["'Fluids/other'", "'set Fluids = water'"],
            text=TOP + section("Fluids", section("other", "")) + "set Fluids = water\n")
    refused("a solid with the name of an entry", ["'Solids'", "'Degree'", "entry", "Allowed: another name"],
            text=TOP + parts("Solids", {"Degree": shape("box", "Corners = 0, 0 : 1, 1")}))

    def two_fluids(*entries):
        """Two columns whose second one has the entries."""
        return TOP + parts("Fluids", {"left": shape("box", "Corners = 0, 0 : 0.1, 0.1"),
                                      "right": shape("box", "Corners = 0.3, 0 : 0.4, 0.1") + "\n".join(entries)})

    refused("fluids of different laws", ["'Fluids/right/Law'", "Newtonian", "one law", "'left'"],
            text=two_fluids("set Law = Newtonian"))
    refused("fluids of one law with different entries", ["'Fluids/right/Law'", "one law", "'Bingham/Density'", "'left'"],
            text=two_fluids(section("Bingham", "set Density = 900")))
    refused("fluids that overlap", ["Fluid 'a' overlaps fluid 'b' at"], text=TOP + parts("Fluids", {
        "a": shape("box", "Corners = 0, 0 : 0.2, 0.2"), "b": shape("box", "Corners = 0.1, 0.1 : 0.3, 0.3")}))
    refused("fluid over one of two boundaries", ["Fluid 'fluid' overlaps boundary 'gate' at"], text=TOP + COLUMN + parts(
        "Boundaries", {"floor": wall("0, 0 : 1, 0"), "gate": wall("0.05, 0 : 0.05, 0.3", "free slip")}))
    with tempfile.TemporaryDirectory() as directory:
        text = two_fluids("set Initial velocity = 1; 0", section("Newtonian", "set Density = 900")) + again.replace(
            "fluid", "left")
        result = run(directory, "case.prm", "--check", text=text)
        check("fluids of one law are taken, whatever another law's entries are", result.returncode == 0, result.stderr)
        result = run(directory, "case.prm", "--check", text=TOP + parts("Fluids", {
            "Wasser 2.0_a-b": shape("box", "Corners = 0, 0 : 0.1, 0.1"), "Öl": shape("box", "Corners = 1, 0 : 2, 1")}))
        check("names of letters, digits, blanks and -_. are taken", result.returncode == 0, result.stderr)


# Entries of the first version, and what the message on each says among other things.
OLD = [("Geometry/Fluid boxes", "'Fluids/NAME/box/Corners'"), ("Geometry/Fluid polygons", "'Fluids/NAME/polygon/Corners'"),
       ("Geometry/Fluid polyhedra", "'Fluids/NAME/convex/Corners'"), ("Geometry/Fluid cones", "'Fluids/NAME/cone/Base'"),
       ("Geometry/Fluid cylinders", "'Fluids/NAME/cylinder/Ends'"), ("Geometry/Fluid groups", "'Fluids/NAME/mesh/Groups'"),
       ("Geometry/No-slip walls", "'Boundaries/NAME/polyline/Points'"),
       ("Geometry/Slip walls", "'Boundaries/NAME/polyline/Points'"),
       ("Geometry/No-slip wall groups", "'Boundaries/NAME/mesh/Groups'"),
       ("Geometry/Slip wall groups", "'Boundaries/NAME/mesh/Groups'"), ("Geometry/Mesh file", "'mesh/File'"),
       ("Geometry/Mesh scale", "'mesh/Scale'"), ("Geometry/Largest number of particles", "'Largest number of particles'"),
       ("Initial velocity", "'Fluids/NAME/Initial velocity'"), ("Fluid/Law", "'Fluids/NAME/Law'"),
       ("Fluid/Bingham/Yield stress", "'Fluids/NAME/Bingham/Yield stress'"),
       ("Fluid/Newtonian/Viscosity", "'Fluids/NAME/Newtonian/Viscosity'"), ("Solids/Number of solids", "'set Solids = NAME"),
       ("Solids/Solid 1/Box", "'Solids/NAME/box/Corners'"), ("Solids/Solid 1/Elements", "'Solids/NAME/box/Elements'"),
       ("Solids/Solid 2/Mesh file", "'Solids/NAME/mesh/File'"), ("Solids/Solid 2/Mesh scale", "'Solids/NAME/mesh/Scale'"),
       ("Solids/Solid 12/Group", "'Solids/NAME/mesh/Groups'"), ("Solids/Solid 1/Clamped", "'Solids/NAME/Clamped'"),
       ("Solids/Solid 1/hypoelastic/Density", "'Solids/NAME/hypoelastic/Density'")]


def test_old_entries():
    for entry, now in OLD:
        refused("the old entry " + entry, ["--set: there is no entry '%s' any more. Allowed: " % entry, now, "convert-case"],
                *set_entry(entry, "1"))
    for subsection in ("Geometry", "Fluid", "Solids/Solid 1"):
        text = "x"
        for name in reversed(subsection.split("/")):
            text = section(name, "" if text == "x" else text)
        refused("the old subsection " + subsection, ["there is no subsection '%s' any more. Allowed: " % subsection,
                                                     "convert-case"], text=GOOD + text)
    for law in ("no slip", "free slip"):
        old = ("No-slip walls", "Slip walls")[law == "free slip"]
        refused("the law that says what %s were" % old, ["'/Law = %s'" % law], *set_entry("Geometry/" + old, "0, 0 : 1, 0"))

    # Each of them, with its line.
    with tempfile.TemporaryDirectory() as directory:
        result = run(directory, "case.prm", text=TOP + """set Initial velocity = 0; 0
subsection Geometry
  set Fluid boxes   = 0, 0 : 0.146, 0.292
  set No-slip walls = 0, 0.4 : 0, 0 : 0.5, 0
end
subsection Fluid
  subsection Bingham
    set Yield stress = 20
  end
end
""")
        first = TOP.count("\n") + 1
        places = {first: "Initial velocity", first + 2: "Geometry/Fluid boxes", first + 3: "Geometry/No-slip walls",
                  first + 7: "Fluid/Bingham/Yield stress"}
        lines = result.stderr.splitlines()
        expected = ["case.prm:%d: there is no entry '%s' any more. Allowed: " % place for place in places.items()]
        check("a file of old entries: status 2", result.returncode == 2, result.returncode)
        check("... and a line for each, in their order, and how to convert them", len(lines) == len(expected) + 1 and all(
            text in line for text, line in zip(expected, lines)) and "convert-case" in lines[-1], result.stderr)
        check("... and nothing is left behind", os.listdir(directory) == ["case.prm"], os.listdir(directory))


def test_printed():
    with tempfile.TemporaryDirectory() as directory:
        write_spike(directory)
        in_space = TOP + "set Dimension = 3\n" + fluid("0, 0, 0 : 1, 1, 1")
        result = run(directory, "--check", *in_spike(), "case.prm", text=in_space)
        check("--check of a mesh with a spike ends", result.returncode == 0 and "Fluid particles" in result.stdout,
              result.returncode, result.stdout, result.stderr)

    with tempfile.TemporaryDirectory() as directory:
        result = run(directory, "--help", text=None)
        check("--help", result.returncode == 0 and all(option in result.stdout for option in
                                                       ["--set", "--check", "--print-parameters", "--version"]), result)
        result = run(directory, "--version", text=None)
        check("--version, nothing else", result.returncode == 0 and
              re.fullmatch(r"lahar \d+\.\d+\.\d+ \(deal\.II \S+\)\n", result.stdout), result.stdout)

        result = run(directory, "--print-parameters", "json", text=None)
        check("--print-parameters json", result.returncode == 0, result.stderr)
        tree = json.loads(result.stdout)
        undocumented = []

        def visit(node, path):
            if isinstance(node, dict) and "value" in node and "documentation" in node:
                if not node["documentation"].strip():
                    undocumented.append(path)
            elif node != "":  # a subsection without entries is an empty text
                for name, child in node.items():
                    visit(child, path + "/" + name)
        visit(tree, "")
        check("every entry is documented", not undocumented, undocumented)
        result = run(directory, "--print-parameters", "latex", text=None)
        check("--print-parameters latex", result.returncode == 0 and "\\subsection" in result.stdout, result.stderr)
        result = run(directory, "--print-parameters", "prm", text=None)
        check("--print-parameters prm", result.returncode == 0 and "set Mesh size" in result.stdout, result.stderr)
        check("nothing written", os.listdir(directory) == [])

        check("--print-parameters prm shows a part of each kind", all(re.search(r"set %s *= %s\b" % item, result.stdout)
              for item in {"Fluids": "fluid", "Boundaries": "boundary", "Solids": "solid"}.items()), result.stdout)

        # The printed parameters are a parameter file, once the parts have shapes.
        result = run(directory, "case.prm", *set_entry(FLUID + "Shape", "box"),
                     *set_entry(FLUID + "box/Corners", "0, 0 : 0.1, 0.1"), *set_entry("Boundaries/boundary/Shape", "polyline"),
                     *set_entry("Boundaries/boundary/polyline/Points", "0, 0 : 1, 0"), *set_entry("Solids/solid/Shape", "box"),
                     *set_entry("Solids/solid/box/Corners", "0.5, 0 : 0.6, 0.1"), "--check", text=result.stdout)
        check("printed parameters can be read", result.returncode == 0, result.stderr)
        result = run(directory, "case.prm", "--check")
        check("--check", result.returncode == 0 and "Fluid cells" in result.stdout, result)
        result = run(directory, "case.prm", "--check", text=GOOD + parts("Solids", {"block": shape(
            "box", "Corners = 0.2, 0 : 0.4, 0.4", "Elements = 1, 1")}))
        check("a solid's contour that is too coarse is reported",
              result.returncode == 0 and "Warning" in result.stdout and "0.2" in result.stdout and "0.03" in result.stdout,
              result)
        result = run(directory, "case.prm", "--check", *set_entry(WALLS + "polyline/Points", "0, 0.4 : 0, 0 : 0.1, 0"))
        check("walls that end under the fluid are reported",
              result.returncode == 0 and "Warning: no wall and no solid lies below" in result.stdout, result)
        check("--check writes nothing", os.listdir(directory) == ["case.prm"])


def read_statistics(path):
    columns, rows = [], []
    with open(path) as file:
        for line in file:
            if line.startswith("#"):
                columns.append(line.split(":", 1)[1].strip())
            elif line.strip():
                rows.append([float(word) for word in line.split()])
    return columns, rows


def check_output(name, out):
    """Everything in an output directory is complete and readable. Return columns and rows of the statistics."""
    files = set(os.listdir(out))
    check(name + ": files", {"parameters.prm", "statistics", "solution.pvd", "log"} <= files, files)
    check(name + ": no half-written files", not [f for f in files if f.endswith(".part") or f.endswith(".tmp")], files)
    entries = ElementTree.parse(os.path.join(out, "solution.pvd")).getroot().findall(".//DataSet")
    names = [entry.attrib["file"] for entry in entries if entry.attrib["part"] != "2"]
    names += sorted({entry.attrib["file"] for entry in entries if entry.attrib["part"] == "2"})  # walls stay the same
    check(name + ": solution.pvd lists the .vtu files",
          names and sorted(names) == sorted(os.path.basename(p) for p in glob.glob(out + "/*.vtu")), names)
    for file in names:
        ElementTree.parse(os.path.join(out, file))
    with open(os.path.join(out, "log")) as file:
        check(name + ": log", "Fluid cells" in file.read())
    if "statistics" not in files:
        return [], []
    columns, rows = read_statistics(os.path.join(out, "statistics"))
    missing = [column for column in COLUMNS if rows and column not in columns]
    check(name + ": columns of the statistics", not missing, missing, columns)
    check(name + ": every row is complete", all(len(row) == len(columns) for row in rows))
    return columns, rows


def test_computed():
    with tempfile.TemporaryDirectory() as directory:
        out = os.path.join(directory, "out")
        result = run(directory, "case.prm")
        check("a small run: status 0", result.returncode == 0, result.stdout, result.stderr)
        columns, rows = check_output("a small run", out)
        time = columns.index("Time (s)")
        check("a small run: one row a step", [row[0] for row in rows] == [1, 2, 3, 4], rows)
        check("a small run: ends at the end time", abs(rows[-1][time] - 4e-3) < 1e-12, rows[-1])
        check("a small run: snapshots at the interval", len(glob.glob(out + "/solution-*.vtu")) == 3)
        names = ["Volume change by solver", "Volume change by remeshing"]
        check("a small run: volume is kept", all(abs(rows[-1][columns.index(name)]) < 1e-3 for name in names), rows[-1])
        check("a small run: the fluid falls", rows[-1][columns.index("Kinetic energy (J)")] > 1e-4, rows[-1])

        # parameters.prm repeats the run.
        again = run(directory, "out/parameters.prm", *set_entry("Output directory", "again"))
        check("parameters.prm repeats the run", again.returncode == 0, again.stderr)
        repeated = read_statistics(os.path.join(directory, "again", "statistics"))[1]
        wall_time = columns.index("Wall time (s)")
        same = all(abs(a - b) <= 1e-6 * abs(a) + 1e-12 for x, y in zip(rows, repeated)
                   for k, (a, b) in enumerate(zip(x, y))
                   if k != wall_time and columns[k] not in ("Velocity increment", "Pressure increment") and
                   "residual" not in columns[k])
        check("and gives the same numbers", same and len(repeated) == len(rows))

    with tempfile.TemporaryDirectory() as directory:
        out = os.path.join(directory, "out")
        result = run(directory, "case.prm", *set_entry("End time", "20"), *set_entry("Time step", "10"),
                     *set_entry("Minimum time step", "10"), *set_entry("Output interval", "0"))
        check("a run that diverges: status 1", result.returncode == 1, result.returncode, result.stderr)
        check("a run that diverges: time and iteration", all(part in result.stderr for part in ["Time 10 s", "iteration"]),
              result.stderr)
        check("a run that diverges: no frame", not [frame for frame in FRAMES if frame in result.stderr], result.stderr)
        columns, rows = check_output("a run that diverges", out)

    # A drop falls beside the column. It has some ten cells, the column more than fifty.
    for smallest, front in [("1", 0.56), ("40", 0.146)]:
        with tempfile.TemporaryDirectory() as directory:
            result = run(directory, "case.prm", *set_entry("End time", "1e-3"),
                         *set_entry(FLUID + "box/Corners", "0, 0 : 0.146, 0.292;\n  0.5, 0.2 : 0.56, 0.26"),
                         *set_entry("Postprocess/Fluid extents/Smallest part", smallest))
            columns, rows = read_statistics(os.path.join(directory, "out", "statistics"))
            found = rows[-1][columns.index("front (m)")]
            check("the front of parts of %s cells at least" % smallest, abs(found - front) < 1e-4, found, result.stderr)

    with tempfile.TemporaryDirectory() as directory:
        out = os.path.join(directory, "out")
        result = run(directory, "case.prm", *set_entry("Nonlinear solver/Maximum iterations", "1"),
                     *set_entry("Nonlinear solver/Tolerance", "1e-12"))
        check("too few iterations: status 1", result.returncode == 1, result.returncode, result.stderr)
        check("too few iterations: message", all(part in result.stderr for part in ["Time ", "iteration 1", "1e-12"]),
              result.stderr)
        check_output("too few iterations", out)


{"refused": test_refused, "printed": test_printed, "computed": test_computed}[sys.argv[1]]()
print("%d failed" % len(failed))
sys.exit(1 if failed else 0)
