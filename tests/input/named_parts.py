#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Test what the program `lahar` says of the names of a case's parts, and of entries that stand elsewhere now.

Usage: named_parts.py parts|old_entries LAHAR MESH_FILE MESH_FILE_IN_SPACE SERVER
"""
import os
import sys
import tempfile

from attempts import COLUMN, GOOD, GROUP, TOP, refused, run, set_entry
from program_test import check, failed, parts, section, shape, wall


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

    refused("a wrong law of the second fluid", ["'Fluids/right/Law'", "'Oldroyd'", "Allowed: ", "Newtonian"],
            text=two_fluids("set Law = Oldroyd"))
    refused("a wrong density of the second fluid", ["'Fluids/right/Bingham/Density'", "'-900'", "Allowed: "],
            text=two_fluids(section("Bingham", "set Density = -900")))
    refused("too many fluids", ["'Fluids'", "31 names", "at most 30"], text=TOP + parts("Fluids", {
        "fluid %d" % i: shape("box", "Corners = %d, 0 : %d.5, 1" % (i, i)) for i in range(31)}))
    refused("fluids that overlap", ["Fluid 'a' overlaps fluid 'b' at"], text=TOP + parts("Fluids", {
        "a": shape("box", "Corners = 0, 0 : 0.2, 0.2"), "b": shape("box", "Corners = 0.1, 0.1 : 0.3, 0.3")}))
    refused("fluid over one of two boundaries", ["Fluid 'fluid' overlaps boundary 'gate' at"], text=TOP + COLUMN + parts(
        "Boundaries", {"floor": wall("0, 0 : 1, 0"), "gate": wall("0.05, 0 : 0.05, 0.3", "free slip")}))
    with tempfile.TemporaryDirectory() as directory:
        text = two_fluids("set Initial velocity = 1; 0", section("Newtonian", "set Density = 900")) + again.replace(
            "fluid", "left")
        result = run(directory, "case.prm", "--check", text=text)
        check("fluids of one law are taken", result.returncode == 0, result.stderr)
        text = two_fluids("set Law = Newtonian", section("Newtonian", "set Density = 900")) + again.replace("fluid", "left")
        result = run(directory, "case.prm", "--check", text=text)
        check("fluids of two laws are taken", result.returncode == 0, result.stderr)
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
        refused("the law that says what %s were" % old, ["/Law = %s'" % law], *set_entry("Geometry/" + old, "0, 0 : 1, 0"))

    # A slip of the pen in today's form is none of them.
    refused("a subsection 'Fluid' of today's form", ["case.prm:", "there is no subsection 'Fluid'", "'Fluids'", "llowed"],
            text=GOOD.replace("subsection Fluids", "subsection Fluid"))
    refused("many old entries", ["There are 4 more such entries", "convert-case"], text=TOP + section("Fluid", section(
        "Bingham", "".join("set %s = 1\n" % name for name in ("Density", "Yield stress", "Plastic viscosity", "Yield",
                                                              "Bulk modulus", "Regularization", "A", "B")))))

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


{"parts": test_names, "old_entries": test_old_entries}[GROUP]()
print("%d failed" % len(failed))
sys.exit(1 if failed else 0)
