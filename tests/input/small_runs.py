#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Test what the program `lahar` prints, and what small runs leave.

printed:  --help, --version, --print-parameters, --check end with status 0.
computed: a small run leaves complete, readable files; so does one that fails, with status 1.

Usage: small_runs.py printed|computed LAHAR MESH_FILE MESH_FILE_IN_SPACE SERVER
"""
import glob
import json
import os
import re
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

from attempts import FLUID, FRAMES, GOOD, GROUP, TOP, WALLS, in_spike, run, set_entry, write_spike
from program_test import check, failed, fluid, parts, shape


COLUMNS = ["Time step number", "Time (s)", "Time step size (s)", "Nonlinear iterations", "Velocity increment",
           "Pressure increment", "Linear iterations", "Held vertices", "Fluid cells", "Solid cells", "Fluid particles",
           "Fluid volume (m^dim)", "Volume change by solver", "Volume change by remeshing", "Remeshed",
           "Kinetic energy (J)", "Wall time (s)"]


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


{"printed": test_printed, "computed": test_computed}[GROUP]()
print("%d failed" % len(failed))
sys.exit(1 if failed else 0)
