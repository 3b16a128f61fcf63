#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Older parameter files, which `lahar` refuses, are taken once contrib/utilities/convert-case has written them in
the form of today, and the first mesh is that of the same case written by hand.

Usage: convert_case.py LAHAR
"""
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path.insert(0, os.path.join(ROOT, "tests"))

from program_test import ALONE, check, failed, fluid, mesh, parts, section, shape, wall, walls  # noqa: E402

LAHAR = os.path.abspath(sys.argv[1])
MESHES = os.path.join(ROOT, "tests", "geometry")
SIZE = "set Mesh size = 0.03\n"
SPACE = "set Dimension = 3\nset Mesh size = 0.1\n"
TANK = "0, 0.4 : 0, 0 : 0.3, 0 : 0.3, 0.4"
FLOOR = "-1, -1, 0 : 2, -1, 0 : 2, 2, 0 : -1, 2, 0"
WEIGHT = section("Bingham", "set Density = 1200", "set Yield stress = 20")
RUBBER = section("hypoelastic", "set Density = 1100", "set Young's modulus = 1e6")
SWIRL = "set Initial velocity = 0.1*y; -0.1*x\n"


def geometry(*settings):
    """The old subsection."""
    return section("Geometry", *("set " + setting for setting in settings))


# Names, old texts and the same cases as they are written today.
CASES = [
    ("boxes in the plane", SIZE + SWIRL + geometry(
        "Fluid boxes = 0, 0 : 0.1, 0.2; 0.2, 0 : 0.3, 0.1", "No-slip walls = " + TANK, "Largest number of particles = 5000") +
     section("Fluid", "set Law = Bingham", WEIGHT),
     SIZE + "set Largest number of particles = 5000\n" + fluid(
         "0, 0 : 0.1, 0.2; 0.2, 0 : 0.3, 0.1", SWIRL, "set Law = Bingham\n", WEIGHT) + walls(TANK)),
    ("slip walls and a polygon", SIZE + geometry(
        "Fluid polygons = 0, 0 : 0.2, 0 : 0, 0.2", "Slip walls = 0, 0.4 : 0, 0", "No-slip walls = 0, 0 : 0.5, 0"),
     SIZE + parts("Fluids", {"fluid": shape("polygon", "Corners = 0, 0 : 0.2, 0 : 0, 0.2")}) +
     parts("Boundaries", {"walls": wall("0, 0 : 0.5, 0"), "slip walls": wall("0, 0.4 : 0, 0", "free slip")})),
    ("all of a mesh file, and a box", SIZE + geometry(
        "Mesh file = groups_41.msh", "Mesh scale = 2", "Fluid groups = fluid", 'Slip wall groups = "left wall"',
        "No-slip wall groups = floor", "Fluid boxes = 1, 0 : 1.2, 0.2", "No-slip walls = 1, 0 : 2, 0") + section("Fluid", WEIGHT),
     SIZE + parts("Fluids", {"fluid": shape("box", "Corners = 1, 0 : 1.2, 0.2") + WEIGHT,
                             "fluid 2": mesh("groups_41.msh", "fluid", 2.) + WEIGHT}) +
     parts("Boundaries", {"walls": wall("1, 0 : 2, 0"), "walls 2": mesh("groups_41.msh", "floor", 2.),
                          "slip walls": mesh("groups_41.msh", '"left wall"', 2.) + "set Law = free slip"})),
    ("cones, a cylinder and a polyhedron", SPACE + geometry(
        "Fluid cones = 0, 0, 0 : 0.3, 0.2, 0.4; 1, 0, 0 : 0.3, 0.3, 0.4", "Fluid cylinders = 0, 1, 0 : 0, 1, 0.5 : 0.2",
        "Fluid polyhedra = 1, 1, 0 : 1.5, 1, 0 : 1, 1.5, 0 : 1, 1, 0.5", "No-slip walls = " + FLOOR),
     SPACE + parts("Fluids", {
         "cone": shape("cone", "Base = 0, 0, 0", "Base radius = 0.3", "Top radius = 0.2", "Height = 0.4"),
         "drum": shape("cone", "Base = 1, 0, 0", "Base radius = 0.3", "Top radius = 0.3", "Height = 0.4"),
         "bar": shape("cylinder", "Ends = 0, 1, 0 : 0, 1, 0.5", "Radius = 0.2"),
         "corner": shape("convex", "Corners = 1, 1, 0 : 1.5, 1, 0 : 1, 1.5, 0 : 1, 1, 0.5")}) + walls(FLOOR)),
    ("a mesh file in space", SPACE + geometry("Mesh file = basin_41.msh", "Fluid groups = fluid", "No-slip wall groups = walls"),
     SPACE + parts("Fluids", {"fluid": mesh("basin_41.msh", "fluid")}) + parts("Boundaries", {"walls": mesh("basin_41.msh", "walls")})),
    ("a solid of a box and one of a mesh file, the third counts for nothing", SIZE + section(
        "Solids", "set Number of solids = 2", "set Degree = 1",
        section("Solid 2", "set Mesh file = groups_41.msh", "set Mesh scale = 2", "set Group = fluid", RUBBER),
        section("Solid 1", "set Box = 1, 0 : 1.1, 0.2", "set Elements = 3, 5", "set Clamped = 1, 0 : 1.1, 0", RUBBER),
        section("Solid 3", "set Box = 2, 0 : 2.1, 0.2")),
     SIZE + parts("Solids", {"beam": shape("box", "Corners = 1, 0 : 1.1, 0.2", "Elements = 3, 5") +
                             "set Clamped = 1, 0 : 1.1, 0\n" + RUBBER, "block": mesh("groups_41.msh", "fluid", 2.) + RUBBER},
                  "set Degree = 1")),
    ("a subsection in two pieces, an entry twice, lines that go on", SIZE + geometry("Fluid boxes = 0, 0 : 9, 9") + geometry(
        "Fluid boxes = 0, 0 : \\\n 0.1, 0.2", "No-slip walls = " + TANK) + section("Fluid", "set Law = Newtonian") +
     section("Fluid", section("Newtonian", "set Density = 900")),
     SIZE + fluid("0, 0 : 0.1, 0.2", "set Law = Newtonian\n", section("Newtonian", "set Density = 900")) + walls(TANK)),
]


def convert(text, *options):
    return subprocess.run([sys.executable, "-B", os.path.join(ROOT, "contrib", "utilities", "convert-case"), *options, "-"],
                          input=text, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=ALONE)


def run(directory, text, name="case.prm", **files):
    """`lahar --check` of a text beside the mesh files."""
    for file, data in dict({name: text}, **files).items():
        with open(os.path.join(directory, file), "w") as out:
            out.write(data)
    return subprocess.run([LAHAR, "--check", name], cwd=directory, env=ALONE, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=300)


def test_cases(directory):
    for name, old, new in CASES:
        refused = run(directory, old)
        check(f"{name}: the old text is refused", refused.returncode == 2 and "any more" in refused.stderr, refused.stderr)
        converted = convert(old, "--solid", "beam", "--solid", "block")
        check("... and converted", converted.returncode == 0 and not converted.stderr, converted.stderr)
        expected, found = run(directory, new), run(directory, converted.stdout)
        check("... the new text is taken", expected.returncode == 0, new, expected.stderr)
        check("... so is the converted one", found.returncode == 0, converted.stdout, found.stderr)
        check("... with the same first mesh", found.stdout == expected.stdout, converted.stdout, found.stdout, expected.stdout)
        again = convert(converted.stdout)
        check("... what is converted stays as it is", again.stdout == converted.stdout, again.stdout, converted.stdout)


def test_text():
    """Comments, names and files that are included."""
    result = convert("# A case.\nset Mesh size = 0.03  # m\n\n# The fluid.\nsubsection Geometry\n  # Two corners.\n"
                     "  set Fluid boxes = 0, 0 : 0.1, 0.2\n  # A floor.\n  set No-slip walls = 0, 0 : 0.5, 0 # rough\nend\n"
                     "# Its law.\nsubsection Fluid\n  subsection Bingham\n    set Yield stress = 20  # Pa\n  end\nend\n"
                     "# The end.\n", "--fluid", "mud", "--walls", "bed")
    lines = [line.strip() for line in result.stdout.splitlines()]
    check("the names are those that are asked for", "set Fluids = mud" in [" ".join(line.split()) for line in lines]
          and "subsection bed" in lines, result.stdout)
    comments = ["# A case.", "# The fluid.", "# Two corners.", "# A floor.", "# Its law.", "# The end."]
    check("comments stay", all(lines.count(comment) == 1 for comment in comments), result.stdout)
    check("... with their entries", "set Yield stress = 20  # Pa" in lines and "set Points = 0, 0 : 0.5, 0  # rough" in lines and
          lines.index("# A floor.") + 1 == lines.index("set Shape = polyline"), result.stdout)
    with tempfile.TemporaryDirectory() as directory:
        law = convert(section("Fluid", "set Law = Newtonian", section("Newtonian", "set Density = 900")))
        case = convert("include law.prm\n" + SIZE + geometry("Fluid boxes = 0, 0 : 0.1, 0.2", "No-slip walls = " + TANK))
        result = run(directory, case.stdout, **{"law.prm": law.stdout})
        check("a law in a file that is included", result.returncode == 0, law.stdout, case.stdout, result.stderr)
    for what, text, words in [("an unknown entry", geometry("Fluid spheres = 1"), "'Geometry/Fluid spheres' is unknown"),
                              ("groups without a file", geometry("Fluid groups = fluid"), "'Geometry/Mesh file'"),
                              ("half a cone", geometry("Fluid cones = 0, 0, 0"), "is no cone"),
                              ("an end too many", SIZE + "end\n", "an 'end' too many")]:
        result = convert(text)
        check(f"{what} is refused in one line", result.returncode == 1 and words in result.stderr
              and result.stderr.count("\n") == 1, result.stderr)


def main():
    with tempfile.TemporaryDirectory() as directory:
        for name in ("groups_41.msh", "basin_41.msh"):
            os.symlink(os.path.join(MESHES, name), os.path.join(directory, name))
        test_cases(directory)
    test_text()
    sys.exit(1 if failed else 0)


main()
