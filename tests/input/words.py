#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Test what `lahar --check` says about words and files that are nearly right, and that it takes those which are right.

entries: unknown entries come with the nearest one, or with the dimension that has it.
lines:   byte order marks and line ends; subsections without 'end' and what is no line, by file and line.
names:   names of files are relative to the file that names them, and absolute in parameters.prm.
meshes:  meshes in other units, groups by names and tags.
places:  points of solids within rounding; closed walls as tanks.

Usage: words.py LAHAR GEOMETRY entries|lines|names|meshes|places      (GEOMETRY: the folder of column_41.msh)
"""
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

from program_test import ALONE, barrier, check, failed, fluid, mesh, parts, section, wall, walls  # noqa: E402

LAHAR, GEOMETRY = [os.path.abspath(path) for path in sys.argv[1:3]]

TOP = """set Dimension = 2
set Output directory = out
set End time = 1e-3
set Mesh size = 0.03
"""
COLUMN = fluid("0, 0 : 0.146, 0.292")
FLOOR = walls("0, 0.4 : 0, 0 : 0.5, 0")
GOOD = TOP + COLUMN + FLOOR
SIZE = "set Mesh size = 0.03\n"


def mesh_case(file, fluid_groups, wall_groups, scale=1.):
    """Fluid and walls of a mesh file."""
    return SIZE + parts("Fluids", {"fluid": mesh(file, fluid_groups, scale)}) + \
        parts("Boundaries", {"walls": mesh(file, wall_groups, scale)})


def mesh_solid(file, scale=1., right=1):
    """A solid of the group 'fluid', clamped below."""
    return parts("Solids", {"barrier": mesh(file, "fluid", scale) + f"set Clamped = 0, 0 : {right}, 0\n" + section(
        "hypoelastic", "set Density = 2500", "set Young's modulus = 1e6", "set Poisson's ratio = 0")})


def after_good(n):
    """The place of line @p n after GOOD."""
    return "case.prm:%d: " % (GOOD.count("\n") + n)


def run(files, *arguments, folder=".", options=("--check",)):
    """Run lahar in @p folder of a new directory with the files, by name, of bytes or text."""
    with tempfile.TemporaryDirectory() as directory:
        for name, data in files.items():
            path = os.path.join(directory, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "wb") as file:
                file.write(data if isinstance(data, bytes) else data.encode())
        os.makedirs(os.path.join(directory, folder), exist_ok=True)
        result = subprocess.run([LAHAR, *options, *arguments], cwd=os.path.join(directory, folder), env=ALONE,
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=300,
                                text=True)
        parameters = os.path.join(directory, folder, "out", "parameters.prm")
        if os.path.exists(parameters):
            with open(parameters) as file:
                result.parameters = file.read()
            result.again = subprocess.run([LAHAR, "--check", "out/parameters.prm"], cwd=os.path.join(directory, folder),
                                          env=ALONE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        return result


def accepted(what, files, *arguments, parts=(), **options):
    result = run(files, *(arguments or ["case.prm"]), **options)
    missing = [part for part in parts if not re.search(part, result.stdout)]
    check(what, result.returncode == 0 and not result.stderr and not missing, missing, result.stdout, result.stderr)
    return result


def refused(what, files, *parts, arguments=("case.prm",), **options):
    """Status 2 and one line that begins with the first part, if that names a line, and holds all."""
    result = run(files if isinstance(files, dict) else {"case.prm": files}, *arguments, **options)
    missing = [part for part in parts if part not in result.stderr]
    check(what, result.returncode == 2 and not missing and result.stderr.count("\n") == 1, missing, result)


def set_entry(text):
    return ("case.prm", "--set", text)


def test_entries():
    for text, nearest in [("Mesh sizes=1", "Mesh size"), ("Fluids/fluid/Bingham/Densty=1", "Fluids/fluid/Bingham/Density"),
                          ("Plastic viscosity=1", "Fluids/fluid/Bingham/Plastic viscosity"), ("Geometry/Mesh size=1", "Mesh size"),
                          ("Solver/Type=direct", "Linear solver/Type")]:
        refused("--set " + text, GOOD, "--set: there is no entry '%s'" % text.split("=")[0],
                "nearest is '" + nearest + "'", "Allowed", arguments=set_entry(text))
    refused("another word for an entry", GOOD, "--set: there is no entry 'Fluids/fluid/box/Opposite vertices'. Allowed in "
            "'Fluids/fluid/box': 'Corners'.", arguments=set_entry("Fluids/fluid/box/Opposite vertices=1"))
    refused("an entry beside comes before one elsewhere", GOOD, "nearest is 'Fluids/fluid/box/Corners'",
            arguments=set_entry("Fluids/fluid/box/Corner=1"))
    refused("nothing is near", GOOD, "there is no entry 'Xyz'. Allowed", arguments=set_entry("Xyz=1"))
    refused("a misspelt entry in the file", GOOD + "set mesh size = 1\n",
            after_good(1) + "there is no entry 'mesh size'", "'Mesh size'")
    refused("a misspelt subsection", GOOD + "\nsubsection fluids\nend\n",
            after_good(2) + "there is no subsection 'fluids'", "'Fluids'")
    refused("a subsection of space in the plane", GOOD + section("Fluids", section("fluid", section(
        "cone", "set Base radius = 1"))), after_good(3) +
            "there is no subsection 'Fluids/fluid/cone' where 'Dimension' is 2", "set Dimension = 3")
    refused("an entry of space in the plane", GOOD, "--set: there is no entry 'Fluids/fluid/cone/Base radius' where "
            "'Dimension' is 2", "set Dimension = 3", arguments=set_entry("Fluids/fluid/cone/Base radius=1"))
    in_space = "set Mesh size = 0.1\n" + fluid("0, 0, 0 : 1, 1, 1")
    refused("a missing Dimension", in_space, "'Fluids/fluid/box/Corners'", "0, 0, 0 : 1, 1, 1", "'Dimension' is 2")
    refused("gravity of space in the plane", GOOD + "set Gravity = 0, 0, -9.81\n", "'Gravity'", "'Dimension' is 2")


def test_lines():
    accepted("a byte order mark", {"case.prm": b"\xef\xbb\xbf" + GOOD.encode()})
    accepted("line ends of Windows", {"case.prm": GOOD.replace("\n", "\r\n")})
    accepted("no line end at the end, a line that goes on",
             {"case.prm": GOOD.strip().replace("0.4 : 0, 0", "0.4 : \\\n  0, 0")})
    capitals = GOOD.replace("set ", "SET ").replace("subsection", "SUBSECTION").replace("end\n", "END # it\n")
    accepted("keywords in capitals", {"case.prm": capitals})
    for encoding in ("utf-16", "utf-16-be", "utf-16-le"):
        refused("text in " + encoding, {"case.prm": GOOD.encode(encoding)}, "case.prm:1: found ", "UTF-16", "UTF-8")
    refused("a missing end", GOOD + "subsection Fluids\n  set Law = Newtonian\nsubsection Solids\nend\n",
            after_good(1) + "the subsection 'Fluids' has no 'end'", "Allowed")
    refused("a missing end at the top", TOP + COLUMN.replace("\nend", "") + "subsection Solids\nend\n",
            "case.prm:6: the subsection 'Fluids'")
    refused("an end too many", GOOD + "\nend\n", after_good(2) + "found 'end'", "Allowed")
    refused("an end too many in an included file",
            {"case.prm": GOOD + "subsection Fluids\ninclude fluid.prm\n", "fluid.prm": "\nend\n"},
            "fluid.prm:2: found 'end'")
    refused("a line without set", GOOD + "Mesh size = 1\n", after_good(1) + "found 'Mesh size = 1'", "set entry = value")
    refused("a set without =", GOOD + "set Mesh size 1\n", after_good(1) + "found 'set Mesh size 1'", "set entry = value")


def test_names():
    with open(os.path.join(GEOMETRY, "column_41.msh")) as file:
        mesh = file.read()
    case = mesh_case("../meshes/column.msh", "fluid", "walls") + "set Output directory = out\nset End time = 1e-3\n"
    files = {"cases/case.prm": case, "meshes/column.msh": mesh}
    accepted("a mesh beside the case", files, "cases/case.prm", parts=["Fluid cells *98"])
    result = accepted("a mesh beside the case, from elsewhere", files, "../cases/case.prm", folder="runs", options=())
    names = re.findall(r"set File *= (\S+)", getattr(result, "parameters", ""))
    check("parameters.prm has the whole name of both parts", len(names) == 2 and all(
          os.path.isabs(name) and name.endswith("/meshes/column.msh") for name in names), names)
    check("parameters.prm is a case", getattr(result, "again", result).returncode == 0, result)
    accepted("on the command line a name is relative to the working directory", files, "../cases/case.prm", "--set",
             "Fluids/fluid/mesh/File=../meshes/column.msh", "--set", "Boundaries/walls/mesh/File=../meshes/column.msh",
             folder="runs")
    refused("a mesh that is not beside the case", dict(files, **{"cases/case.prm": case.replace("../", "")}),
            "Mesh file '", "/cases/meshes/column.msh' does not exist", arguments=["cases/case.prm"])

    accepted("a solid's mesh beside the case", dict(files, **{"cases/case.prm": SIZE + mesh_solid("../meshes/column.msh")}),
             "../cases/case.prm", folder="runs", parts=["Solid cells *128"])

    included = {"a/case.prm": "include parts/fluid.prm\nset Dimension = 2\n",
                "a/parts/fluid.prm": GOOD + section("Fluids", section("fluid", "include ../law.prm")),
                "a/law.prm": "set Law = Newtonian\n"}
    accepted("included files beside their files", included, "../a/case.prm", folder="runs")
    refused("an error in an included file", dict(included, **{"a/law.prm": "\nset Law = \nset Lav = 1\n"}),
            "a/parts/../law.prm:3: there is no entry 'Fluids/fluid/Lav'", "nearest is 'Fluids/fluid/Law'", arguments=["a/case.prm"])
    refused("a missing included file", dict(included, **{"a/case.prm": "\ninclude fluid.prm\n"}),
            "a/case.prm:2: ", "a/fluid.prm", "does not exist", arguments=["a/case.prm"])


def test_meshes():
    file = os.path.join(GEOMETRY, "groups_41.msh")
    for groups in [('"water, at rest"', "floor, left wall"), ("5", "7, 3"), (' fluid ', ' 7 , "left wall"')]:
        accepted("groups %s; %s" % groups, {"case.prm": mesh_case(file, *groups)}, parts=["Fluid cells *98"])
    for group in ('"water, at rest', '"fluid" "water"'):
        refused("groups " + group, mesh_case(file, group, "walls"), "'Fluids/fluid/mesh/Groups'", "double quotes")
    refused("an open wall through a gmsh fluid", SIZE + parts("Fluids", {"fluid": mesh(file, "fluid")}) + parts(
        "Boundaries", {"walls": mesh(file, "walls"), "gate": wall("0.07, 0 : 0.07, 0.2")}),
            "Fluid 'fluid' overlaps boundary 'gate'", "(0.07 ")
    refused("half a name", mesh_case(file, "water, at rest", "walls"), "'water'", "'water, at rest'")
    refused("an unknown tag", mesh_case(file, "fluid", "9"), "'9'", "7 (has no name)")
    refused("a scale of zero", mesh_case(file, "fluid", "walls", 0.), "'Fluids/fluid/mesh/Scale'", "above zero")
    refused("no scale above zero for walls", SIZE + COLUMN + parts("Boundaries", {"walls": mesh(file, "walls", 0.)}),
            "'Boundaries/walls/mesh/Scale'", "above zero")
    with open(file) as original:
        # x 1000: numbers of the nodes only, which have decimals or stand in lines of three
        in_mm = re.sub(r"(?m)^(\S+) (\S+) 0$", lambda m: "%.15g %.15g 0" % (1e3 * float(m[1]), 1e3 * float(m[2])),
                       original.read())
    files = {"case.prm": mesh_case("mm.msh", "fluid", "walls", 1e-3), "mm.msh": in_mm}
    accepted("a mesh in mm", files, parts=["Fluid cells *98", r"Fluid volume *0\.042632"])
    refused("a mesh in mm without its scale", dict(files, **{"case.prm": mesh_case("mm.msh", "fluid", "walls")}),
            "'Fluids/fluid/mesh/Scale' is 1,", "1e-3 for mm", "'Mesh size' is 0.03")
    floor = TOP + COLUMN + parts("Boundaries", {"walls": mesh("mm.msh", "floor")})
    accepted("walls in mm without their scale", dict(files, **{"case.prm": floor}),
             parts=["Warning: the walls of boundary 'walls'.* 500 m.*Boundaries/walls/mesh/Scale",
                                                                        "1e-3 for a mesh in mm"])
    size = "set Mesh size = 0.02\n"
    accepted("a solid in mm", dict(files, **{"case.prm": size + mesh_solid("mm.msh", 1e-3)}), parts=["Solid cells *128"])
    accepted("a solid in mm without its scale",
             dict(files, **{"case.prm": size + mesh_solid("mm.msh", right=1000)}),
             parts=["Warning: the elements of solid 'barrier' .*Solids/barrier/mesh/Scale"])


def test_places():
    for offset in (1e-7, -1e-7):
        clamped = barrier(0.2, 0.23).replace("Clamped = 0.2, 0 : 0.23, 0", "Clamped = %.8f, %.8f : 0.23, %.8f" % (
            0.2 + offset, offset, offset))
        point = "subsection Postprocess\nsubsection Solid points\nset Points = tip: %.8f, %.8f\nend\nend\n" % (
            0.2 - offset, 0.08 + offset)
        accepted("a clamp and a gauge %g m beside the solid" % offset, {"case.prm": GOOD + clamped + point},
                 parts=["Solid nodes"])
    refused("a gauge 1 mm beside the solid",
            GOOD + barrier(0.2, 0.23) + re.sub("tip: .*", "tip: 0.2, 0.081", point), "'tip'", "thousandth")

    def tank(points):
        return TOP + COLUMN + walls(points)

    for points in ("0, 0 : 0.3, 0 : 0.3, 0.4 : 0, 0.4 : 0, 0", "0, 0 : 0, 0.4 : 0.3, 0.4 : 0.3, 0 : 0, 0"):
        same = accepted("open walls", {"case.prm": tank("0, 0.4 : 0, 0 : 0.3, 0 : 0.3, 0.4; 0.3, 0.4 : 0, 0.4")})
        result = accepted("a tank " + points, {"case.prm": tank(points)})
        check("a tank has the fluid of open walls", result.stdout == same.stdout, result.stdout, same.stdout)
    accepted("a full tank", {"case.prm": tank("0, 0 : 0.146, 0 : 0.146, 0.292 : 0, 0.292 : 0, 0")})
    refused("a tank through the fluid", tank("0, 0 : 0.1, 0 : 0.1, 0.4 : 0, 0.4 : 0, 0"), "overlaps boundary 'walls'", "(0.1 ")


{"entries": test_entries, "lines": test_lines, "names": test_names, "meshes": test_meshes,
 "places": test_places}[sys.argv[3]]()
print("%d failed" % len(failed))
sys.exit(len(failed) > 0)
