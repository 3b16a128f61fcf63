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

from program_test import ENVIRONMENT, barrier, check, failed  # noqa: E402

LAHAR, GEOMETRY = [os.path.abspath(path) for path in sys.argv[1:3]]

GOOD = """set Dimension = 2
set Output directory = out
set End time = 1e-3
set Mesh size = 0.03
subsection Geometry
  set Fluid boxes = 0, 0 : 0.146, 0.292
  set No-slip walls = 0, 0.4 : 0, 0 : 0.5, 0
end
"""

MESH = """set Mesh size = 0.03
subsection Geometry
  set Mesh file = %s
  set Fluid groups = %s
  set No-slip wall groups = %s
  set Mesh scale = %g
end
"""


def run(files, *arguments, folder=".", options=("--check",)):
    """Run lahar in @p folder of a new directory with the files, by name, of bytes or text."""
    with tempfile.TemporaryDirectory() as directory:
        for name, data in files.items():
            path = os.path.join(directory, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "wb") as file:
                file.write(data if isinstance(data, bytes) else data.encode())
        os.makedirs(os.path.join(directory, folder), exist_ok=True)
        result = subprocess.run([LAHAR, *options, *arguments], cwd=os.path.join(directory, folder), env=ENVIRONMENT,
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=300,
                                text=True)
        parameters = os.path.join(directory, folder, "out", "parameters.prm")
        if os.path.exists(parameters):
            with open(parameters) as file:
                result.parameters = file.read()
            result.again = subprocess.run([LAHAR, "--check", "out/parameters.prm"], cwd=os.path.join(directory, folder),
                                          env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
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
    for text, nearest in [("Mesh sizes=1", "Mesh size"), ("Fluid/Bingham/Densty=1", "Fluid/Bingham/Density"),
                          ("Density=1", "Fluid/Bingham/Density"), ("Geometry/Mesh size=1", "Mesh size"),
                          ("Solver/Type=direct", "Linear solver/Type")]:
        refused("--set " + text, GOOD, "--set: there is no entry '%s'" % text.split("=")[0],
                "nearest is '" + nearest + "'", "Allowed", arguments=set_entry(text))
    refused("nothing is near", GOOD, "there is no entry 'Xyz'. Allowed", arguments=set_entry("Xyz=1"))
    refused("a misspelt entry in the file", GOOD + "set mesh size = 1\n",
            "case.prm:9: there is no entry 'mesh size'", "'Mesh size'")
    refused("a misspelt subsection", GOOD + "\nsubsection fluid\nend\n",
            "case.prm:10: there is no subsection 'fluid'", "'Fluid'")
    refused("an entry of space in the plane",
            GOOD + "subsection Geometry\n  set Fluid cones = 0, 0, 0 : 1, 1, 1\nend\n",
            "case.prm:10: there is no entry 'Geometry/Fluid cones' where 'Dimension' is 2", "set Dimension = 3")
    in_space = "set Mesh size = 0.1\nsubsection Geometry\n  set Fluid boxes = 0, 0, 0 : 1, 1, 1\nend\n"
    refused("a missing Dimension", in_space, "'Geometry/Fluid boxes'", "0, 0, 0 : 1, 1, 1", "'Dimension' is 2")
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
    refused("a missing end", GOOD + "subsection Fluid\n  set Law = Newtonian\nsubsection Solids\nend\n",
            "case.prm:9: the subsection 'Fluid' has no 'end'", "Allowed")
    refused("a missing end at the top", GOOD.replace("\nend", "") + "subsection Fluid\nend\n",
            "case.prm:5: the subsection 'Geometry'")
    refused("an end too many", GOOD + "\nend\n", "case.prm:10: found 'end'", "Allowed")
    refused("an end too many in an included file",
            {"case.prm": GOOD + "subsection Fluid\ninclude fluid.prm\n", "fluid.prm": "\nend\n"},
            "fluid.prm:2: found 'end'")
    refused("a line without set", GOOD + "Mesh size = 1\n", "case.prm:9: found 'Mesh size = 1'", "set entry = value")
    refused("a set without =", GOOD + "set Mesh size 1\n", "case.prm:9: found 'set Mesh size 1'", "set entry = value")


def test_names():
    with open(os.path.join(GEOMETRY, "column_41.msh")) as file:
        mesh = file.read()
    case = MESH % ("../meshes/column.msh", "fluid", "walls", 1.) + "set Output directory = out\nset End time = 1e-3\n"
    files = {"cases/case.prm": case, "meshes/column.msh": mesh}
    accepted("a mesh beside the case", files, "cases/case.prm", parts=["Fluid cells *97"])
    result = accepted("a mesh beside the case, from elsewhere", files, "../cases/case.prm", folder="runs", options=())
    entry = re.search(r"Mesh file *= (\S*)", getattr(result, "parameters", ""))
    check("parameters.prm has the whole name",
          entry and os.path.isabs(entry[1]) and entry[1].endswith("/meshes/column.msh"), entry)
    check("parameters.prm is a case", getattr(result, "again", result).returncode == 0, result)
    accepted("on the command line a name is relative to the working directory", files, "../cases/case.prm", "--set",
             "Geometry/Mesh file=../meshes/column.msh", folder="runs")
    refused("a mesh that is not beside the case", dict(files, **{"cases/case.prm": case.replace("../", "")}),
            "Mesh file '", "/cases/meshes/column.msh' does not exist", arguments=["cases/case.prm"])

    solid = barrier(0, 1).replace("set Box     = 0, 0 : 1, 0.08",
                                  "set Mesh file = ../meshes/column.msh\nset Group = fluid")
    accepted("a solid's mesh beside the case", dict(files, **{"cases/case.prm": "set Mesh size = 0.03\n" + solid}),
             "../cases/case.prm", folder="runs", parts=["Solid cells *128"])

    included = {"a/case.prm": "include parts/fluid.prm\nset Dimension = 2\n",
                "a/parts/fluid.prm": GOOD + "subsection Fluid\ninclude ../law.prm\nend\n",
                "a/law.prm": "set Law = Newtonian\n"}
    accepted("included files beside their files", included, "../a/case.prm", folder="runs")
    refused("an error in an included file", dict(included, **{"a/law.prm": "\nset Law = \nset Lav = 1\n"}),
            "a/parts/../law.prm:3: there is no entry 'Fluid/Lav'", "nearest is 'Fluid/Law'", arguments=["a/case.prm"])
    refused("a missing included file", dict(included, **{"a/case.prm": "\ninclude fluid.prm\n"}),
            "a/case.prm:2: ", "a/fluid.prm", "does not exist", arguments=["a/case.prm"])


def test_meshes():
    file = os.path.join(GEOMETRY, "groups_41.msh")
    for fluid, walls in [('"water, at rest"', "floor, left wall"), ("5", "7, 3"), (' fluid ', ' 7 , "left wall"')]:
        accepted("groups %s; %s" % (fluid, walls), {"case.prm": MESH % (file, fluid, walls, 1.)},
                 parts=["Fluid cells *97"])
    for fluid in ('"water, at rest', '"fluid" "water"'):
        refused("groups " + fluid, MESH % (file, fluid, "walls", 1.), "'Geometry/Fluid groups'", "double quotes")
    refused("an open wall through a gmsh fluid", MESH % (file, "fluid", "walls", 1.) +
            "subsection Geometry\n  set No-slip walls = 0.07, 0 : 0.07, 0.2\nend\n", "overlaps wall", "(0.07 ")
    refused("half a name", MESH % (file, "water, at rest", "walls", 1.), "'water'", "'water, at rest'")
    refused("an unknown tag", MESH % (file, "fluid", "9", 1.), "'9'", "7 (has no name)")
    refused("a scale of zero", MESH % (file, "fluid", "walls", 0.), "'Geometry/Mesh scale'", "above zero")
    with open(file) as mesh:
        # x 1000: numbers of the nodes only, which have decimals or stand in lines of three
        in_mm = re.sub(r"(?m)^(\S+) (\S+) 0$", lambda m: "%.15g %.15g 0" % (1e3 * float(m[1]), 1e3 * float(m[2])),
                       mesh.read())
    files = {"case.prm": MESH % ("mm.msh", "fluid", "walls", 1e-3), "mm.msh": in_mm}
    accepted("a mesh in mm", files, parts=["Fluid cells *97", r"Fluid volume *0\.0422"])
    refused("a mesh in mm without its scale", dict(files, **{"case.prm": MESH % ("mm.msh", "fluid", "walls", 1.)}),
            "'Geometry/Mesh scale' is 1,", "1e-3 for mm", "'Mesh size' is 0.03")
    floor = MESH % ("mm.msh", "", "floor", 1.) + re.sub(".*No-slip walls.*", "", GOOD)
    accepted("walls in mm without their scale", dict(files, **{"case.prm": floor}),
             parts=["Warning: the walls of 'Geometry/Mesh file'.* 500 m", "1e-3 for a mesh in mm"])
    solid = "set Mesh size = 0.02\n" + barrier(0, 1).replace(
        "set Box     = 0, 0 : 1, 0.08", "set Mesh file = mm.msh\n set Group = fluid\n set Mesh scale = %g")
    accepted("a solid in mm", dict(files, **{"case.prm": solid % 1e-3}), parts=["Solid cells *128"])
    accepted("a solid in mm without its scale",
             dict(files, **{"case.prm": (solid % 1.).replace("0 : 1, 0\n", "0 : 1000, 0\n")}),
             parts=["Warning: the elements of Solid 1 .*Solids/Solid 1/Mesh scale"])


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

    def tank(walls):
        return GOOD.replace("0, 0.4 : 0, 0 : 0.5, 0", walls)

    for walls in ("0, 0 : 0.3, 0 : 0.3, 0.4 : 0, 0.4 : 0, 0", "0, 0 : 0, 0.4 : 0.3, 0.4 : 0.3, 0 : 0, 0"):
        same = accepted("open walls", {"case.prm": tank("0, 0.4 : 0, 0 : 0.3, 0 : 0.3, 0.4; 0.3, 0.4 : 0, 0.4")})
        result = accepted("a tank " + walls, {"case.prm": tank(walls)})
        check("a tank has the fluid of open walls", result.stdout == same.stdout, result.stdout, same.stdout)
    accepted("a full tank", {"case.prm": tank("0, 0 : 0.146, 0 : 0.146, 0.292 : 0, 0.292 : 0, 0")})
    refused("a tank through the fluid", tank("0, 0 : 0.1, 0 : 0.1, 0.4 : 0, 0.4 : 0, 0"), "overlaps wall", "(0.1 ")


{"entries": test_entries, "lines": test_lines, "names": test_names, "meshes": test_meshes,
 "places": test_places}[sys.argv[3]]()
print("%d failed" % len(failed))
sys.exit(len(failed) > 0)
