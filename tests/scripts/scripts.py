#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The scripts in contrib/ on short runs.

benchmarks: contrib/benchmarks runs what is chosen, skips what is finished, and writes tables whose numbers are those of the
            statistics, and figures.
plots:      contrib/plot/*.py draw a run in the plane and one in space, and refuse wrong input in one line with status 2; the
            section of a box at rest is a rectangle whose size is known. Those that need VTK are left out where it is missing.

Usage: scripts.py GROUP LAHAR. Exit status 77 (skipped) without numpy or matplotlib.
"""
import importlib.util
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, ".."))
from program_test import ALONE, ENVIRONMENT, check, failed, fluid, walls

CONTRIB = os.path.abspath(os.path.join(HERE, "..", "..", "contrib"))
SKIPPED = 77
BOX = """
set Dimension        = %d
set Output directory = out
set End time         = 2e-3
set Time step        = 1e-3
set Mesh size        = 0.02
set Output interval  = 1e-3
set Gravity          = %s
"""


def run_script(directory, name, *arguments):
    """The finished process of the script @p name of contrib/, run in @p directory."""
    return subprocess.run([sys.executable, "-B", os.path.join(CONTRIB, name), *arguments], cwd=directory, env=ENVIRONMENT,
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def is_refused(process, *words):
    """Status 2 and one line on stderr that has all @p words in it."""
    return (process.returncode == 2 and len(process.stderr.splitlines()) == 1
            and all(word in process.stderr for word in words))


def is_drawing(path):
    """Whether there is a picture that shows more than its background."""
    import matplotlib.image
    return os.path.isfile(path) and matplotlib.image.imread(path)[..., :3].std() > 0.01


def read_table(path):
    """The rows of a table in Markdown, each a dictionary by the names in the head."""
    with open(path) as file:
        rows = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in file if line.startswith("|")]
    return [dict(zip(rows[0], row)) for row in rows[2:]]


def last_and_first(path):
    """The columns of the last and of the first line of a statistics file by name, and how many lines there are."""
    with open(path) as file:
        lines = file.read().splitlines()
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("#")]
    rows = [line.split() for line in lines if line.strip() and not line.startswith("#")]
    return dict(zip(names, map(float, rows[-1]))), dict(zip(names, map(float, rows[0]))), len(rows)


def test_benchmarks(lahar, directory):
    runs = {"dam_break_rigid": "tau100-h0.004-plain", "dam_break_elastic": "tau100-h0.012-p2",
            "bentonite_slope": "a-wedge-tau165", "bentonite_channel": "plane-h0.0168"}
    arguments = ["--only", *runs.values(), "--set", "End time=4e-3", "--lahar", lahar, "--output", "runs", "--doc", "doc"]
    process = run_script(directory, "benchmarks", *arguments)
    check("the runs end with status 0", process.returncode == 0, process.stdout, process.stderr)
    check("and there is no complaint", not process.stderr, process.stderr)
    for case, name in runs.items():
        folder = os.path.join(directory, "runs", case, name)
        last, first, n_steps = last_and_first(os.path.join(folder, "statistics"))
        check(f"{name} has run to its end", abs(last["Time (s)"] - 4e-3) < 1e-9 and n_steps > 1, last["Time (s)"], n_steps)
        rows = read_table(os.path.join(directory, "doc", "benchmarks", case + "_table.md"))
        check(f"the table of {case} has this run only", len(rows) == 1, rows)
        for column, value in (("rejected steps", last["Rejected steps"]), ("wall time (s)", last["Wall time (s)"]),
                              ("triangles at the start", first["Fluid cells"]),
                              ("fluid cells at the start", first["Fluid cells"])):
            if column in rows[0]:
                check(f"'{column}' is that of the statistics", rows[0][column] == f"{value:.0f}", rows[0][column], value)
    for figure in ("dam_break_elastic_snapshots.png", "bentonite_slope_front.png", "bentonite_channel_front.png"):
        check(f"{figure} shows something", is_drawing(os.path.join(directory, "doc", "figures", figure)), process.stdout)

    process = run_script(directory, "benchmarks", *arguments)
    check("finished runs are skipped", process.returncode == 0 and "4 runs, 4 of them finished" in process.stdout
          and "started" not in process.stdout, process.stdout)
    process = run_script(directory, "benchmarks", "--list", *arguments)
    check("and listed as finished", process.stdout.count(" finished\n") == 4 and len(process.stdout.splitlines()) == 4,
          process.stdout)

    process = run_script(directory, "benchmarks", "--only", "tau7*", *arguments[-6:])
    check("an unknown run is refused", is_refused(process, "tau7*"), process.returncode, process.stderr)
    process = run_script(directory, "benchmarks", "--lahar", "nowhere", *arguments[-4:])
    check("so is a program that is not there", is_refused(process, "nowhere"), process.returncode, process.stderr)
    process = run_script(directory, "benchmarks", "--only", runs["bentonite_channel"], "--set", "Mesh size=-1", *arguments[-6:])
    check("a run that fails gives status 1 and its message", process.returncode == 1 and "Mesh size" in process.stdout,
          process.returncode, process.stdout)


def test_plots(lahar, directory):
    def compute(name, dimension, gravity, corners, points):
        folder = os.path.join(directory, name)
        os.mkdir(folder)
        with open(os.path.join(folder, "case.prm"), "w") as file:
            file.write(BOX % (dimension, gravity) + fluid(corners) + walls(points))
        process = subprocess.run([lahar, "case.prm"], cwd=folder, env=ALONE, stdin=subprocess.DEVNULL,
                                 stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        check(f"there is a run in {name}", process.returncode == 0, process.stderr)
        return os.path.join(name, "out")

    plane = compute("the_plane", 2, "0, -9.81", "0, 0 : 0.1, 0.06", "0, 0.1 : 0, 0 : 0.1, 0 : 0.1, 0.1")
    for script, picture, *options in (("plot/front.py", "front.png"), ("plot/snapshots.py", "flow.png"),
                                      ("plot/snapshots.py", "pressure.png", "--field", "pressure", "--times", "1e-3")):
        process = run_script(directory, script, plane, "-o", picture, *options)
        check(f"{script} draws {picture}", process.returncode == 0 and is_drawing(os.path.join(directory, picture)),
              process.stderr)
    process = run_script(directory, "plot/front.py", plane, "-o", "a.png", "--column", "mood")
    check("front.py refuses a column that is not there", is_refused(process, "mood", "statistics"), process.stderr)
    process = run_script(directory, "plot/snapshots.py", plane, "-o", "a.png", "--field", "mood")
    check("snapshots.py refuses a field that is not there", is_refused(process, "mood"), process.stderr)
    for script in ("plot/front.py", "plot/snapshots.py"):
        process = run_script(directory, script, "nowhere", "-o", "a.png")
        check(f"{script} refuses a run that is not there", is_refused(process, "nowhere"), process.stderr)

    if not importlib.util.find_spec("vtkmodules"):
        print("section.py and render.py are not tested: no VTK for Python")
        return
    sides = "; ".join(["0, 0, 0 : 0.1, 0, 0 : 0.1, 0.08, 0 : 0, 0.08, 0",
                       *(f"{x}, 0, 0 : {x}, 0.08, 0 : {x}, 0.08, 0.1 : {x}, 0, 0.1" for x in (0, 0.1)),
                       *(f"0, {y}, 0 : 0.1, {y}, 0 : 0.1, {y}, 0.1 : 0, {y}, 0.1" for y in (0, 0.08))])
    space = compute("space", 3, "0, 0, -9.81", "0, 0, 0 : 0.1, 0.08, 0.06", sides)
    process = run_script(directory, "plot/section.py", space, "--plane", "y=0.041", "--times", "0", "--to", "section.png",
                         "--text", "section.txt")
    check("section.py draws", process.returncode == 0 and is_drawing(os.path.join(directory, "section.png")), process.stderr)
    with open(os.path.join(directory, "section.txt")) as file:
        points = [[float(word) for word in line.split()] for line in file if line.strip() and not line.startswith("#")]
    extent = [(min(values), max(values)) for values in zip(*points)]
    check("and its contour is as wide and as high as the fluid",
          all(abs(found - exact) < 1e-8 for found, exact in zip((*extent[0], *extent[1]), (0., 0.1, 0., 0.06))), extent)
    check("and lies in the plane", all(abs(y - 0.041) < 1e-8 for y in extent[3]), extent)
    for cut in ("y", "w=1", "y=nowhere"):
        process = run_script(directory, "plot/render.py", space, "--cut", cut)
        check(f"render.py refuses the plane '{cut}'", is_refused(process, "--cut", cut), process.stderr)
    process = run_script(directory, "plot/render.py", space, "--cut", "y=1")
    check("and one with nothing behind it", is_refused(process, "no fluid", "y=1"), process.stderr)
    for script in ("plot/section.py", "plot/render.py"):
        process = run_script(directory, script, "nowhere")
        check(f"{script} refuses a run that is not there", is_refused(process, "nowhere"), process.stderr)


def main():
    if not importlib.util.find_spec("numpy") or not importlib.util.find_spec("matplotlib"):
        print("not tested: numpy or matplotlib is missing")
        sys.exit(SKIPPED)
    group, lahar = sys.argv[1], os.path.abspath(sys.argv[2])
    with tempfile.TemporaryDirectory() as directory:
        {"benchmarks": test_benchmarks, "plots": test_plots}[group](lahar, directory)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
