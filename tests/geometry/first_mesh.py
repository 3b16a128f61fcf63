#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Test the first mesh by whole runs: fluid of a mesh file rests between walls of any spacing and in a shell, pools
beside a thin partition rest, warnings tell of what the mesh cannot show, and a solid that meets a wall or a solid ends
the run.

Usage: first_mesh.py LAHAR
"""
import math
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

from program_test import ALONE, check, failed, fluid, mesh, new_case, parts, shape, wall, walls  # noqa: E402

LAHAR = os.path.abspath(sys.argv[1])

WATER = """
set Law = Newtonian
subsection Newtonian
  set Density   = 1000
  set Viscosity = %s
end
"""


def write_mesh(path, groups):
    """Write groups {name: (points, triangles)} as a gmsh file; the groups share no nodes."""
    nodes, elements, tag = [], [], 0
    for number, (points, triangles) in enumerate(groups.values(), 1):
        elements += [(number, *(tag + 1 + corner for corner in triangle)) for triangle in triangles]
        nodes += points
        tag += len(points)
    with open(path, "w") as file:
        file.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n%d\n" % len(groups))
        for number, name in enumerate(groups, 1):
            file.write('2 %d "%s"\n' % (number, name))
        file.write("$EndPhysicalNames\n$Nodes\n%d\n" % len(nodes))
        for number, (x, y) in enumerate(nodes, 1):
            file.write("%d %.17g %.17g 0\n" % (number, x, y))
        file.write("$EndNodes\n$Elements\n%d\n" % len(elements))
        for number, (group, a, b, c) in enumerate(elements, 1):
            file.write("%d 2 2 %d %d %d %d %d\n" % (number, group, group, a, b, c))
        file.write("$EndElements\n")


def grid(place, n, m, closed=False):
    """n × m rectangles of place(i/n, j/m), each as two triangles; closed: the last column is the first."""
    columns = n if closed else n + 1
    points = [place(i / n, j / m) for j in range(m + 1) for i in range(columns)]
    triangles = []
    for j in range(m):
        for i in range(n):
            a, b = j * columns + i, j * columns + (i + 1) % columns
            c, d = b + columns, a + columns
            triangles += [(a, b, c), (a, c, d)] if (i + j) % 2 else [(a, b, d), (b, c, d)]
    return points, triangles


def disc(radius, n_rings, n_outer):
    """A disc of rings whose outermost has n_outer nodes and, inside, a fan."""
    points, triangles = grid(lambda s, t: (radius * (1 - t * (n_rings - 1) / n_rings) * math.cos(2 * math.pi * s),
                                           radius * (1 - t * (n_rings - 1) / n_rings) * math.sin(2 * math.pi * s)),
                             n_outer, n_rings - 1, closed=True)
    first = (n_rings - 1) * n_outer
    points.append((0., 0.))
    triangles += [(first + i, first + (i + 1) % n_outer, len(points) - 1) for i in range(n_outer)]
    return points, triangles


def run(directory, *arguments):
    return subprocess.run([LAHAR, "case.prm", *arguments], cwd=directory, env=ALONE, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=600, text=True)


def statistics(directory):
    """The columns by name."""
    with open(os.path.join(directory, "out", "statistics")) as file:
        lines = file.read().splitlines()
    names = [line.split(": ", 1)[1] for line in lines if re.match(r"# \d+: ", line)]
    rows = [[float(word) for word in line.split()] for line in lines if not line.startswith("#")]
    return {name: [row[i] for row in rows] for i, name in enumerate(names)}


def check_rest(what, directory, volume, missing, mass):
    """The run in the directory is at rest from the first step to the last, with the volume but what is missing in
    hollow corners."""
    result = run(directory)
    check(what + ": status 0", result.returncode == 0, result.stderr)
    if result.returncode:
        return {}
    columns = statistics(directory)
    speed = math.sqrt(2 * max(columns["Kinetic energy (J)"]) / mass)
    check(what + ": at rest", speed < 1e-10, speed)
    volumes = columns["Fluid volume (m^dim)"]
    check(what + ": the whole volume", -1e-9 < volume - volumes[0] <= missing, volumes[0], volume)
    check(what + ": keeps it", max(volumes) - min(volumes) < 1e-10 * volume, min(volumes), max(volumes))
    return columns


def still_columns(parent):
    """Two halves that do not share their nodes, between walls whose particles are h apart."""
    for name, left, right in [("alike", 0.02, 0.02), ("halves", 0.02, 0.0125), ("graded", 0.01, 0.04)]:
        for h in (0.04, 0.032, 0.025, 0.02, 0.016, 0.0125, 0.01, 0.008):
            directory = new_case(parent, "column_%s_%g" % (name, h), """
set Output directory = out
set End time         = 0.02
set Time step        = 2e-3
set Mesh size        = %g
""" % h + parts("Fluids", {"fluid": mesh("column.msh", "left, right") + WATER % "1e-3"}) + walls(
                "0, 0.5 : 0, 0 : 0.2, 0 : 0.2, 0.5") + """
subsection Postprocess
  subsection Point gauges
    set Points = deep: 0.1, 0.05
  end
end
""")
            def half(x, size, graded):
                def place(s, t):
                    return (x + 0.1 * s, 0.3 * (t * (0.5 + 0.5 * t) if graded else t))
                return grid(place, round(0.1 / size), round(0.3 / size))
            write_mesh(os.path.join(directory, "column.msh"),
                       {"left": half(0., left, name == "graded"), "right": half(0.1, right, name == "graded")})
            # Three wall particles in each hollow corner may leave a cell out.
            columns = check_rest("gmsh column, %s, h = %g m" % (name, h), directory, 0.06, 2 * 0.6 * h * h, 60.)
            if columns:
                pressures = columns["deep pressure (Pa)"]
                check("  pressure", max(abs(p + 9810. * 0.25) for p in pressures) < 1e-6 * 2452.5, pressures)


def shells(parent):
    """A ring of rubber full of fluid under pressure from outside: Lamé's solution with a fixed inner radius."""
    for degree, n in ((2, 64), (1, 64), (2, 96)):
        directory = new_case(parent, "shell_%d_%d" % (degree, n), """
set Output directory = out
set End time         = 0.08
set Time step        = 1e-3
set Mesh size        = 0.01
set Gravity          = 0, 0
""" + parts("Fluids", {"fluid": mesh("shell.msh", "inside") + WATER % "1"}) + parts("Solids", {
            "shell": mesh("shell.msh", "shell") + """
set Loaded   = -1, -1 : 1, 1
set Traction = if(x*x+y*y>0.011, -1000*min(1,t/0.05)*x/sqrt(x*x+y*y), 0); \\
               if(x*x+y*y>0.011, -1000*min(1,t/0.05)*y/sqrt(x*x+y*y), 0)
subsection hypoelastic
  set Density         = 1100
  set Young's modulus = 1e6
  set Poisson's ratio = 0.3
end
"""}, "set Degree        = %d" % degree, "set Newmark gamma = 0.8") + """
subsection Postprocess
  subsection Point gauges
    set Points = centre: 0.001, 0.002
  end
  subsection Solid points
    set Points = outside: 0.11, 0
  end
end
""")
        ring = grid(lambda s, t: ((0.1 + 0.01 * t) * math.cos(2 * math.pi * s),
                                  (0.1 + 0.01 * t) * math.sin(2 * math.pi * s)), n, 1, closed=True)
        inside = disc(0.1, 10, n)
        write_mesh(os.path.join(directory, "shell.msh"), {"inside": inside, "shell": ring})
        result = run(directory)
        name = "shell of degree %d, %d elements" % (degree, n)
        check(name + ": status 0", result.returncode == 0, result.stderr)
        if result.returncode == 0:
            columns = statistics(directory)
            volume = 0.5 * n * 0.01 * math.sin(2 * math.pi / n)
            check(name + ": volume", abs(columns["Fluid volume (m^dim)"][-1] / volume - 1) < 1e-3,
                  columns["Fluid volume (m^dim)"][-1], volume)
            pressure = columns["centre pressure (Pa)"][-1]
            check(name + ": pressure", abs(pressure + 1052.2) < (5 if degree == 2 else 15), pressure)
            name_of_x = [column for column in columns if column.startswith("outside") and column.endswith("x (m)")][0]
            moved = columns[name_of_x][-1]
            check(name + ": displacement", abs(moved + 7.46e-6) < 0.1 * 7.46e-6, moved)


BASIN = """
set Output directory = out
set End time         = 0.1
set Time step        = 5e-3
set Mesh size        = 0.025
""" + fluid("0, 0 : 0.5, 0.4; %s, 0 : 1, 0.1", WATER % "1e-3") + walls("0, 0.6 : 0, 0 : 1, 0 : 1, 0.6; %s") + """
subsection Postprocess
  subsection Wall forces
    set Boxes = partition: 0.4999, 0.0001 : 0.55, 0.61; whole: 0.4999, -1e-4 : 0.55, 0.61
  end
end
"""


def partitions(parent):
    for thickness in (0.003, 0.005, 0.01, 0.03):
        x = "%g" % (0.5 + thickness)
        directory = new_case(parent, "partition_" + x, BASIN % (x, "0.5, 0 : 0.5, 0.6 : %s, 0.6 : %s, 0" % (x, x)))
        columns = check_rest("partition %g m thick" % thickness, directory, 0.2 + (0.5 - thickness) * 0.1,
                             4 * 0.6 * 0.025**2, 250.)
        if columns:
            force = columns["partition force x (N)"]
            check("  its force", max(abs(f - 698.9625) for f in force) < 1e-6, force)
    directory = new_case(parent, "partition_without", (BASIN % ("0.5", "0.5, 0 : 0.5, 0.6")).replace("no slip", "wall particles"))
    result = run(directory, "--check")
    check("a partition without thickness whose particles both sides share is reported", result.returncode == 0 and
          "both sides of a wall" in result.stdout and "(0.5 " in result.stdout, result.stdout, result.stderr)


def warnings(parent):
    """What the warnings name, and that there are none where all is right."""
    base = """
set Output directory = out
set End time         = 0.5
set Time step        = 1e-3
set Mesh size        = 0.02
"""
    def output(name, boxes, points, *arguments):
        directory = new_case(parent, name, base + fluid(boxes) + walls(points))
        result = run(directory, "--check", *arguments)
        check(name + ": status 0", result.returncode == 0, result.stderr)
        return result.stdout

    text = output("tank", "0, 0 : 0.2, 0.2", "0, 0.3 : 0, 0 : 0.6, 0 : 0.6, 0.3")
    check("a good case has no warning", "Warning" not in text, text)
    check("--check says what a run takes", all(part in text for part in
          ["Thinnest part    10 mesh sizes", "Time steps       500", "Estimate", " s and ", " MiB"]), text)
    text = output("film", "0, 0 : 0.4, 0.05", "0, 0.3 : 0, 0 : 0.6, 0 : 0.6, 0.3")
    check("a thin film is reported", "the fluid is 2.5 mesh sizes thick" in text, text)
    check("  and in the line of --check", "Thinnest part    2.5 mesh sizes" in text, text)
    text = output("gap", "0, 0 : 0.2, 0.2", "0, 0.3 : 0, 0 : 0.6, 0 : 0.6, 0.3; "
                  "0.3, 0.3 : 0.3, 0.03 : 0.35, 0.03 : 0.35, 0.3")
    check("a narrow gap is reported", "the gap between boundary number" in text and "0.03 m, 1.5 mesh sizes" in text, text)
    floor = "-0.2, -0.2, 0 : 0.6, -0.2, 0 : 0.6, 0.4, 0 : -0.2, 0.4, 0"
    top = "; 0.3, 0, %g : 0.36, 0, %g : 0.36, 0.08, %g : 0.3, 0.08, %g" % (4 * (0.045,))
    sides = "".join("; %g, %g, 0 : %g, %g, 0 : %g, %g, 0.045 : %g, %g, 0.045" % (a + b + b + a) for a, b in (
        ((0.3, 0.), (0.36, 0.)), ((0.36, 0.), (0.36, 0.08)), ((0.36, 0.08), (0.3, 0.08)), ((0.3, 0.08), (0.3, 0.))))
    for name, points, reported in (("table", floor + top, True), ("box", floor + top + sides, False),
                                   ("box_open_on_one_side", floor + top + sides[:sides.rindex(";")], True)):
        directory = new_case(parent, name, base + "set Dimension = 3\n" + fluid("0, 0, 0 : 0.1, 0.1, 0.1") + walls(points))
        result = run(directory, "--check")
        check("a %s on a floor: a gap is %sreported" % (name, "" if reported else "not "), result.returncode == 0 and
              ("the gap between boundary number" in result.stdout) == reported, result.stdout, result.stderr)
    text = output("full", "0, 0 : 0.2, 0.2", "0, 0 : 0.2, 0; 0.2, 0 : 0.2, 0.2; 0.2, 0.2 : 0, 0.2; 0, 0.2 : 0, 0")
    check("fluid without a free surface is reported", "no free surface" in text, text)
    for degree, elements, reported in ((1, 2, True), (1, 4, False), (2, 1, False)):
        directory = new_case(parent, "barrier_%d_%d" % (degree, elements), base + fluid("0, 0 : 0.2, 0.2") + walls(
            "0, 0.3 : 0, 0 : 0.6, 0 : 0.6, 0.3") + parts("Solids", {"barrier": shape(
                "box", "Corners = 0.3, 0 : 0.31, 0.1", f"Elements = {elements}, 20") +
                "set Clamped = 0.3, 0 : 0.31, 0\n"}, f"set Degree = {degree}"))
        result = run(directory, "--check")
        check("a barrier of %d elements of degree %d across" % (elements, degree), result.returncode == 0
              and ("a solid is 0.01 m" in result.stdout) == reported, result.stdout, result.stderr)
    text = output("round", "0, 0 : 0.2, 0.2", "0, 0 : 0.3, 0", "--set", "Fluids/fluid/Shape=polygon", "--set",
                  "Fluids/fluid/polygon/Corners=0, 0 : 0.02, 0 : 0.021, 0.2 : 0.02, 0.021 : 0.019, 0.2 : 0, 0.02")
    volumes = re.search(r"the first mesh has (\S+) m\^2 of fluid, and (\S+) m\^2", text)
    check("a mesh that cannot show the shape is reported", volumes and float(volumes[1]) != float(volumes[2]), text)


def solids(parent):
    """A solid that meets something ends the run with status 1; one that only touches does not."""
    base = """
set Output directory = out
set End time         = %s
set Time step        = 1e-3
set Mesh size        = 0.02
set Output interval  = 1
set Gravity          = 0, %s
"""

    def body(corners, speed="0", clamped=""):
        return shape("box", "Corners = " + corners) + f"""
set Initial velocity = {speed}; 0
set Clamped          = {clamped}
subsection hypoelastic
  set Density         = 1200
  set Young's modulus = 1e6
end
"""

    block = parts("Solids", {"block": body("-0.05, 0.1 : 0.05, 0.2")})
    for law in ("no slip", "free slip"):
        for name, points in (("floor", "-0.5, 0 : 0.5, 0"), ("post", "0.001, -1 : 0.001, 0.01"),
                             ("slope", "-0.5, -0.2 : 0.5, 0.1")):
            directory = new_case(parent, "block_%s_%s" % (law, name), base % ("0.4", "-9.81") +
                                 parts("Boundaries", {name: wall(points, law)}) + block)
            result = run(directory)
            found = re.search(r"Time (\S+) s: solid 'block' has run into boundary '%s' at \(\S+ \S+\) m" % name,
                              result.stderr)
            check("a block falls on a %s of %s" % (name, law), result.returncode == 1 and found, result.stderr)
            if found and name != "slope":
                time = math.sqrt(2 * (0.1 if name == "floor" else 0.09) / 9.81)
                check("  when it gets there", time < float(found[1]) < time + 6e-3, found[1], time)
    for distance, reached in (("0.2", True), ("0.9", False)):
        two = parts("Solids", {"left": body("0, 0 : 0.1, 0.1", "1"), "right": body(
            "%s, 0.02 : %g, 0.12" % (distance, float(distance) + 0.1), "-1")})
        directory = new_case(parent, "blocks_" + distance, base % ("0.12", "0") + walls("-9, -9 : 9, -9") + two)
        result = run(directory)
        found = re.search(r"Time (\S+) s: solid '(?:left' has run into solid 'right|right' has run into solid 'left)' "
                          r"at \((\S+) (\S+)\) m", result.stderr)
        check("blocks %s m apart" % distance, (result.returncode == 1 and found and 0.05 <= float(found[1]) < 0.06)
              if reached else result.returncode == 0, result.stderr)
    for name, corners, height in [
            ("floor", "-1, -1, 0 : 1, -1, 0 : 1, 1, 0 : -1, 1, 0", 0.1),
            ("blade", "0.003, -1, -1 : 0.003, 1, -1 : 0.003, 1, 0.02 : 0.003, -1, 0.02", 0.08)]:
        directory = new_case(parent, "block_in_space_" + name, """
set Dimension        = 3
set Output directory = out
set End time         = 0.2
set Time step        = 2e-3
set Mesh size        = 0.02
set Output interval  = 1
""" + walls(corners) + parts("Solids", {"block": shape("box", "Corners = -0.04, -0.04, 0.1 : 0.04, 0.04, 0.18") + """
subsection hypoelastic
  set Density         = 1200
  set Young's modulus = 1e6
end
"""}))
        result = run(directory)
        found = re.search(r"Time (\S+) s: solid 'block' has run into boundary 'walls'", result.stderr)
        time = math.sqrt(2 * height / 9.81)
        check("a block falls on a %s in space" % name, result.returncode == 1 and found
              and time < float(found[1]) < time + 1e-2, result.stderr, time)
    fixed = parts("Solids", {"barrier": body("0, 0 : 0.02, 0.1", "0.5", "0, 0 : 0.02, 0")})
    directory = new_case(parent, "barrier", base % ("0.1", "-9.81") + walls("-0.5, 0 : 0.5, 0") + fixed)
    result = run(directory)
    check("a barrier that swings on a floor goes on", result.returncode == 0, result.stderr)


def main():
    with tempfile.TemporaryDirectory() as parent:
        for test in (still_columns, shells, partitions, warnings, solids):
            test(parent)
    return 1 if failed else 0


sys.exit(main())
