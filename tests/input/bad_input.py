#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Test that the program `lahar` refuses wrong input: it ends with status 2; the message names the parameter by its path,
the value found and what is allowed; it shows no C++ or deal.II frame, and nothing is left behind.

Usage: bad_input.py refused LAHAR MESH_FILE MESH_FILE_IN_SPACE SERVER
"""
import os
import sys

from attempts import FLUID, GOOD, MESH, MESH_IN_SPACE, TOP, WALLS, in_spike, refused, set_entry, write_spike, wrong
from program_test import barrier, failed, fluid, parts, section, shape, wall, walls


def test_inflows(model):
    """Inflow and outflow."""
    inflow, outflow = WALLS + "inflow/", WALLS + "outflow/"
    wrong(inflow + "Velocity", "", "'Discharge table'", "0 are given", more=model("Law", "inflow"))
    wrong(inflow + "Velocity", "1", "2 are given",
          more=[*model("Law", "inflow"), *set_entry(inflow + "Discharge", "1")])
    wrong(inflow + "Velocity", "x", "time t", more=model("Law", "inflow"))
    wrong(inflow + "Profile", "y; y", "coordinates", more=[*model("Law", "inflow"), *set_entry(inflow + "Velocity", "1")])
    wrong(outflow + "Direction", "", "side", more=model("Law", "outflow"))
    wrong(outflow + "Direction", "1, 0, 0", "2 components", more=model("Law", "outflow"))
    out = [*model("Law", "outflow"), *set_entry(outflow + "Direction", "1, 0")]
    wrong(outflow + "Level", "x", "time t", more=out)
    wrong(outflow + "Level", "0.1; 0.2", "time t", more=out)
    wrong(outflow + "Level", "0.1", "both are given", more=[*out, *set_entry(outflow + "Level table", "level.csv")])
    wrong(WALLS + "Motion", "translation", "fixed", more=[*model("Law", "inflow"), *set_entry(inflow + "Velocity", "1")])

    def inlet(points, entry="Velocity = 1"):
        return shape("polyline", "Points = " + points) + "set Law = inflow\n" + section("inflow", "set " + entry)

    def case(**boundaries):
        return TOP + fluid("0, 0 : 0.146, 0.292") + parts("Boundaries", dict(floor=wall("0, 0 : 0.5, 0"), **boundaries))

    left = "0, 0 : 0, 0.292"
    refused("a hydrograph that goes back in time", ["hydrograph.csv:3:", "'0.5, 2'", "after", "llowed"],
            text=case(river=inlet(left, "Discharge table = hydrograph.csv")),
            prepare=lambda directory: write(directory, "hydrograph.csv", "0, 1\n1, 2\n0.5, 2\n"))
    refused("a hydrograph that becomes negative", ["'Boundaries/river/inflow/Discharge table'", "-0.004 at", "llowed", "zero or above"],
            text=case(river=inlet(left, "Discharge table = hydrograph.csv")),
            prepare=lambda directory: write(directory, "hydrograph.csv", "0, 1\n0.002, -1\n"))
    refused("two inflows on one face", ["'river'", "'pipe'", "(0 0.05", "one inflow"],
            text=case(river=inlet(left), pipe=inlet("0, 0.05 : 0, 0.2")))
    refused("two boundaries on one face", ["'bed'", "'floor'", "lie on each other at (0.", "one boundary"],
            text=case(bed=wall("0.02, 0 : 0.1, 0", "free slip")))
    refused("an inflow inside a wall", ["'river'", "'block'", "(0.3 0.05", "rigid bodies"],
            text=case(river=inlet("0.3, 0.05 : 0.3, 0.15"), block=wall("0.2, 0.02 : 0.4, 0.02 : 0.4, 0.2 : 0.2, 0.2 : 0.2, 0.02")))
    refused("an inflow without fluid", ["'river'", "no fluid touches it at (0.3", "llowed"],
            text=case(river=inlet("0.3, 0.05 : 0.3, 0.15")))
    refused("an inflow that is bent", ["'river'", "not plane", "0.02 m", "llowed"],
            text=case(river=inlet("0, 0 : 0, 0.1 : -0.02, 0.2")))
    refused("an inflow of another fluid", ["'Boundaries/river/inflow/Fluid'", "'oil'", "'fluid'", "llowed"],
            *set_entry("Boundaries/river/inflow/Fluid", "oil"), text=case(river=inlet(left)))
    refused("an outflow with fluid behind it", ["'weir'", "behind it", "llowed"],
            text=case(weir=shape("polyline", "Points = 0.1, 0 : 0.1, 0.3") + "set Law = outflow\n" +
                      section("outflow", "set Direction = 1, 0")))


    def weir(points, *entries):
        return case(weir=shape("polyline", "Points = " + points) + "set Law = outflow\n" +
                    section("outflow", "\n".join(("set Direction = 1, 0", *entries))))

    upright = "0.3, 0 : 0.3, 0.3"
    refused("a level that is not finite", ["'Boundaries/weir/outflow/Level'", "1 / t", "llowed", "finite"],
            text=weir(upright, "set Level = 1 / t"))
    refused("levels that go back in time", ["level.csv:3:", "'0.5, 2'", "after", "llowed"],
            text=weir(upright, "set Level table = level.csv"),
            prepare=lambda directory: write(directory, "level.csv", "0, 1\n1, 2\n0.5, 2\n"))
    refused("a level at an outflow that lies", ["'Boundaries/weir/outflow/Level'", "'weir'", "llowed", "stands"],
            text=weir("0.3, 0.1 : 0.5, 0.1001", "set Level = 0.1").replace("Direction = 1, 0", "Direction = 0, 1"))


def test_rotational_symmetry():
    """What makes no sense of the half plane (r, z)."""
    def case(body="0, 0 : 0.146, 0.292", points="0, 0 : 0.5, 0", law="", name="floor"):
        return (TOP + "set Geometry = rotational symmetry\n" + fluid(body) +
                parts("Boundaries", {name: shape("polyline", "Points = " + points) + law}))

    symmetry = "'rotational symmetry'"
    for what, expected, text, arguments in [
            ("in space", ["'Geometry'", symmetry, "'Dimension' is 3"],
             TOP + "set Dimension = 3\nset Geometry = rotational symmetry\n" + fluid("0, 0, 0 : 1, 1, 1"), []),
            ("gravity across the axis", ["'Gravity'", "1, -9.81", "0, g"], case(), set_entry("Gravity", "1, -9.81")),
            ("fluid beyond the axis", ["'fluid'", "x = -0.1", "x >= 0"], case(body="-0.1, 0 : 0.1, 0.1"), []),
            ("a wall beyond the axis", ["'floor'", "x = -0.1", "x >= 0"], case(points="-0.1, 0 : 0.5, 0"), []),
            ("a wall along the axis", ["'floor'", "along the axis", "boundary by itself"], case(points="0, 1 : 0, 0 : 0.5, 0"), []),
            ("a boundary of the axis' name", ["'axis'", "another name"], case(name="axis"), []),
            ("a wall that moves aside", ["'floor'", "moves in x", "along y"],
             case(law="set Motion = translation\n" + section("translation", "set Displacement = 0.1 * t; 0")), []),
            ("an outflow", ["'floor'", "lets fluid in or out", "rigid"],
             case(law="set Law = outflow\n" + section("outflow", "set Direction = 0, -1")), []),
            ("solids", ["'Solids'", "barrier", "nothing"], case() + barrier(0.2, 0.212), []),
            ("the stabilisation FIC", ["'Stabilization/Form'", "FIC", "Geometry"], case(), set_entry("Stabilization/Form", "FIC")),
            ("another geometry", ["'Geometry'", "sphere", "plane|rotational symmetry"], case(), set_entry("Geometry", "sphere"))]:
        refused("rotational symmetry: " + what, [*expected, "llowed"], *arguments, text=text)


def write(directory, name, text):
    with open(os.path.join(directory, name), "w") as file:
        file.write(text)


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
                         (FLUID + "Bingham/Augmentation parameter", "0"), (FLUID + "Bingham/Augmentation parameter", "-3"),
                         (FLUID + "Bingham/Augmentation parameter", "large"),
                         (FLUID + "Bingham/Bulk modulus", "-1"), (FLUID + "Bingham/Bulk modulus", "soft"),
                         (FLUID + "Bingham/Flocculation time", "0"), (FLUID + "Bingham/Flocculation time", "-2"),
                         (FLUID + "Bingham/Flocculation time", "long"), (FLUID + "Bingham/Deflocculation parameter", "-0.1"),
                         (FLUID + "Bingham/Initial structure", "-1"),
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

    # Fluid laws: numbers, and a table with a wrong line.
    for law, entry, value in [("Herschel-Bulkley", "Flow index", "0"), ("Herschel-Bulkley", "Consistency", "-1"),
                              ("power law", "Smallest strain rate", "0"), ("Casson", "Casson viscosity", "-1"),
                              ("Carreau-Yasuda", "Exponent of the bend", "0"), ("Cross", "Exponent", "1.5"),
                              ("table", "File", ""), ("Drucker-Prager", "Friction angle", "90"),
                              ("Drucker-Prager", "Friction angle", "-5"), ("mu(I)", "Grain density", "900"),
                              ("mu(I)", "Grain diameter", "0"), ("mu(I)", "Static friction", "0"),
                              ("mu(I)", "Dynamic friction", "0.2"), ("mu(I) Barker-Gray", "Creep exponent", "2")]:
        wrong(FLUID + law + "/" + entry, value, more=set_entry(FLUID + "Law", law))

    def write_table(directory):
        with open(os.path.join(directory, "mud.csv"), "w") as file:
            file.write("# strain rate, stress\n0, 12\n1, 13\n2, 12.5\n")

    table = set_entry(FLUID + "Law", "table")
    refused("a table whose stress falls", ["mud.csv:4:", "'2, 12.5'", "llowed", "larger"], *table,
            *set_entry(FLUID + "table/File", "mud.csv"), prepare=write_table)
    refused("a missing table", ["nowhere.csv", "does not exist"], *table, *set_entry(FLUID + "table/File", "nowhere.csv"))

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
    wrong(points, "0, 0.4 : 0, 0 : 1, 0 : 0, 0.4 : 0, 0.4", "two different points")
    # Boundaries that resist and move.
    def model(kind, name):
        return set_entry(WALLS + kind, name)

    wrong(WALLS + "Motion", "sliding", "fixed", "rotation", "table", "translation")
    wrong(WALLS + "translation/Displacement", "t", "2 functions", more=model("Motion", "translation"))
    wrong(WALLS + "translation/Displacement", "x; 0", "time t", more=model("Motion", "translation"))
    wrong(WALLS + "rotation/Angle", "t; t", "one function", more=model("Motion", "rotation"))
    wrong(WALLS + "table/File", "", "name of a table", more=model("Motion", "table"))
    refused("a boundary that jumps at the start", ["Boundary 'walls' is displaced by (0.1 0) m at 'Start time'",
            "'Boundaries/walls/Motion'", "Allowed"], *model("Motion", "translation"),
            *set_entry(WALLS + "translation/Displacement", "0.1; 0"))
    refused("a table that is not there", ["nowhere.csv", "does not exist", "Allowed"], *model("Motion", "table"),
            *set_entry(WALLS + "table/File", "nowhere.csv"))
    wrong(WALLS + "Coulomb/Friction coefficient", "-0.1", more=model("Law", "Coulomb"))
    wrong(WALLS + "Navier slip/Slip coefficient", "0", more=model("Law", "Navier slip"))
    wrong(WALLS + "yield slip/Sliding yield stress", "0", more=model("Law", "yield slip"))
    test_inflows(model)
    test_rotational_symmetry()
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
    refused("a size of elements that are there", ["'Fluids/fluid/mesh/Element size'", "0.01", MESH, "llowed: 0"],
            *mesh(FLUID, MESH, "fluid"), *set_entry(FLUID + "mesh/Element size", "0.01"))
    refused("a drawing without a size of elements", ["'Fluids/fluid/mesh/Element size'", "tank.step", "llowed"],
            *mesh(FLUID, "tank.step", "1"))
    refused("a missing drawing", ["tank.step", "does not exist", "llowed"], *mesh(FLUID, "tank.step", "1"),
            *set_entry(FLUID + "mesh/Element size", "0.01"))
    refused("a script that gmsh cannot read", ["wrong.geo", "line 1", "llowed"], *mesh(FLUID, "wrong.geo", "fluid"),
            prepare=lambda directory: write(directory, "wrong.geo", "Point(1) = {0, 0;\n"))
    refused("a mesh file that is none", ["case.prm:", "$MeshFormat"], *mesh(FLUID, "case.prm", "fluid"))

    # What would need too much memory.
    refused("too many particles", ["'Mesh size'", "1e-09", "fluid 'fluid'", "Largest number of particles", "10000000"],
            *set_entry("Mesh size", "1e-9"))
    refused("walls out of all scale", ["'Mesh size'", "boundary 'walls'", "at most 1e+07"],
            *set_entry(points, "0, 0.4 : 0, 0 : 1e30, 0"))
    refused("more particles than set", ["'Mesh size'", "fluid 'fluid'", "which is 10,"],
            *set_entry("Largest number of particles", "10"))
    refused("Largest number of particles = 1e9", ["'Largest number of particles'", "1e9", "llowed"],
            *set_entry("Largest number of particles", "1e9"))
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
    wrong("Solids/beam/Surface/Law", "inflow", "Allowed", "Coulomb", "free slip", more=solid(beside))
    wrong("Solids/beam/Shape", "ball", "box", "mesh", more=solid(beside))
    wrong("Solids/beam/box/Elements", "2, 0", "2 whole numbers", more=solid(beside))
    wrong("Solids/beam/box/Corners", "0, 0 : 0, 1", "differ in every coordinate", more=solid(beside))
    wrong("Solids/beam/Clamped", "1, 1 : 1, 2", "no part of the contour of solid 'beam'", more=solid(beside))
    wrong("Solids/beam/Traction", "1", "functions", more=solid(beside))
    refused("a solid of too many nodes", ["'beam'", "Solids/Largest number of nodes", "1000000", "Elements"],
            *solid(beside, "S/box/Elements=10000, 10000"))
    refused("a solid out of all scale", ["Solid 'beam'", "'Mesh size'", "direction y", "1e-05 to 100000"],
            *solid("0.25, 0 : 0.26, 1e19", "S/box/Elements=2, 4"))
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
    refused("--set of an unknown entry", ["Fluids/fluid/Densities", "nearest is 'Fluids/fluid/", "/Density'", "--print-parameters"],
            *set_entry("Fluids/fluid/Densities", "1"))
    moments = "Postprocess/Moments/Points"
    refused("moments of nobody", [moments, "'nobody'", "no boundary and no solid", "'walls'"], *set_entry(moments, "nobody: 0, 0"))
    refused("moments about two points", [moments, "'walls' twice"], *set_entry(moments, "walls: 0, 0; walls: 1, 0"))
    refused("moments about no point", [moments], *set_entry(moments, "walls: 0"))
    refused("moments with rotational symmetry", [moments, "rotational symmetry"], *set_entry(moments, "walls: 0, 0"),
            *set_entry("Geometry", "rotational symmetry"), *set_entry("Boundaries/walls/polyline/Points", "0, 0 : 1, 0"))
    refused("--set in an unknown subsection", ["Liquid/Density"], *set_entry("Liquid/Density", "1"))
    refused("--set without a value", ["Time step", "Section/Subsection/Entry=value"], "--set", "Time step")
    refused("--set of nothing", ["Section/Subsection/Entry=value"], "--set", "=1")
    refused("--set without argument", ["set"], "--set")
    refused("unknown format", ["xml", "prm, json, latex"], "--print-parameters", "xml")

    # A path below a regular file cannot be created, whoever asks.
    for value in ("case.prm/out", ""):
        refused("Output directory = " + value, ["'Output directory'", value, "llowed"], *set_entry("Output directory", value))


test_refused()
print("%d failed" % len(failed))
sys.exit(1 if failed else 0)
