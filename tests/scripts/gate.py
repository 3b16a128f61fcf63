#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""contrib/plot/gate.py and barrier.py on files that are known: water that leaves a tank at a steady rate, in triangles that
the gate cuts; forces whose largest value, sliding mean and impulse are known. Wrong input is refused in one line with
status 2.

Usage: gate.py. Exit status 77 (skipped) without numpy or matplotlib.
"""
import importlib.util
import os
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, ".."), HERE]
from program_test import check, failed
from scripts import SKIPPED, is_drawing, is_refused, run_script

GATE, DISCHARGE, LEVEL = 0.3, 0.02, 0.5  # m, m²/s, m
STEP, N_STEPS = 0.05, 8


def write_statistics(path, columns):
    with open(path, "w") as file:
        file.writelines(f"# {i + 1}: {name}\n" for i, name in enumerate(columns))
        for row in zip(*columns.values()):
            file.write(" ".join(f"{value:.17g}" for value in row) + "\n")


def write_water(path, depth):
    """A rectangle from 0 to 0.8 m, so deep left of the gate that @p depth times 0.3 m is there: two strips of triangles whose
    edges do not stand at the gate."""
    xs = (0., 0.17, 0.41, 0.8)
    points = [(x, y) for x in xs for y in (0., depth)]
    cells = [cell for k in range(3) for cell in ((2 * k, 2 * k + 2, 2 * k + 3), (2 * k, 2 * k + 3, 2 * k + 1))]
    with open(path, "w") as file:
        file.write('<VTKFile type="UnstructuredGrid" byte_order="LittleEndian"><UnstructuredGrid>'
                   f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}"><Points>'
                   '<DataArray Name="Points" type="Float64" format="ascii" NumberOfComponents="3">'
                   + " ".join(f"{x!r} {y!r} 0" for x, y in points) + "</DataArray></Points><Cells>"
                   + "".join(f'<DataArray Name="{name}" type="{kind}" format="ascii">{" ".join(map(str, values))}</DataArray>'
                             for name, kind, values in (("connectivity", "Int32", [i for cell in cells for i in cell]),
                                                        ("offsets", "Int32", [3 * (i + 1) for i in range(len(cells))]),
                                                        ("types", "UInt8", len(cells) * [5])))
                   + "</Cells><PointData></PointData></Piece></UnstructuredGrid></VTKFile>")


def test_gate(directory):
    folder = os.path.join(directory, "water")
    os.mkdir(folder)
    times = [STEP * k for k in range(N_STEPS + 1)]
    levels = [LEVEL - DISCHARGE * time / GATE for time in times]
    for k, level in enumerate(levels):
        write_water(os.path.join(folder, f"solution-{k}.vtu"), level)
    with open(os.path.join(folder, "solution.pvd"), "w") as file:
        file.write('<VTKFile type="Collection"><Collection>' + "".join(
            f'<DataSet timestep="{time!r}" part="0" file="solution-{k}.vtu"/>' for k, time in enumerate(times))
            + "</Collection></VTKFile>")
    write_statistics(os.path.join(folder, "statistics"), {
        "Time (s)": times[1:], "level (m)": levels[1:], "tip x (m)": [0.1 * time for time in times[1:]],
        "tip y (m)": [0.01 * time for time in times[1:]]})
    process = run_script(directory, "plot/gate.py", "water", "--gate", str(GATE), "--opening", "0.01", "--to", "gate.png")
    check("it draws the gate", process.returncode == 0 and not process.stderr
          and is_drawing(os.path.join(directory, "gate.png")), process.stderr)
    row = process.stdout.splitlines()[-1].split(" | ")
    exact = ", ".join(f"{1e3 * DISCHARGE * time:.2f}" for time in (0.05, 0.1, 0.2, 0.3, 0.4))
    check("what has left the tank is exact", row[1] == exact, row, exact)
    check("the largest displacement is the last one", row[3] == "40.0, 0.400", row)
    for what, words, *arguments in (
            ("labels of other number", ("--labels", "allowed"), "water", "--gate", "0.3", "--labels", "a", "b"),
            ("a run that is not there", ("nowhere",), "nowhere", "--gate", "0.3")):
        check(what + " is refused", is_refused(run_script(directory, "plot/gate.py", *arguments), *words))


def test_barrier(directory):
    folder = os.path.join(directory, "forces")
    os.mkdir(folder)
    steps = [0.1] * 10 + [0.05] * 20
    times = [sum(steps[:k + 1]) for k in range(len(steps))]
    pushed = [4000. if 1.01 < time < 1.26 else 0. for time in times]  # five steps of 0.05 s
    write_statistics(os.path.join(folder, "statistics"), {
        "Time (s)": times, "Time step size (s)": steps, "dam fluid force x (N)": [-force for force in pushed],
        "dam support force x (N)": pushed, "top x (m)": [-0.2 if time > 1.99 else -0.1 for time in times]})
    process = run_script(directory, "plot/barrier.py", "forces", "--solid", "dam", "--point", "top", "--along=-x",
                         "--to", "forces.png")
    check("it draws forces", process.returncode == 0 and not process.stderr
          and is_drawing(os.path.join(directory, "forces.png")), process.stderr)
    for words in ("largest 4000 N at 1.05 s", "largest 2000 N until 1.25 s", "fluid 1000, support -1000 N s",
                  "top: largest 0.2 m at 2 s, at the end 0.2 m"):
        check("it prints: " + words, words in process.stdout, process.stdout)
    for what, words, *arguments in (("a solid that is not there", ("no column", "wall fluid force"), "--solid", "wall"),
                                    ("a mean over no time", ("--mean", "allowed"), "--solid", "dam", "--mean", "0")):
        check(what + " is refused", is_refused(run_script(directory, "plot/barrier.py", "forces", *arguments), *words))


if not all(importlib.util.find_spec(name) for name in ("numpy", "matplotlib")):
    sys.exit(SKIPPED)
with tempfile.TemporaryDirectory() as parent:
    test_gate(parent)
    test_barrier(parent)
sys.exit(1 if failed else 0)
