#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""contrib/plot/rim.py on a disc whose rim is known: radii that alternate from sector to sector, so that mean, standard
deviation and range are exact, and a spread that jumps once. Wrong input is refused in one line with status 2. render.py
shows the disc on the whole of its floor (with VTK and xvfb-run).

Usage: rim.py. Exit status 77 (skipped) without numpy or matplotlib.
"""
import importlib.util
import math
import os
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, ".."), HERE]
from program_test import ENVIRONMENT, check, failed
from scripts import CONTRIB, SKIPPED, is_drawing, is_refused, run_script

SIZE, N_SECTORS, RADIUS, TOOTH = 0.01, 40, 0.096, 0.001  # m; 2 pi radius/(1.5 SIZE) rounded down is 40 with both radii
JUMP, JUMP_TIME = 0.007, 0.5


def write_cells(path, points, cells, kind):
    """A snapshot at rest of cells of VTK's @p kind."""
    with open(path, "w") as file:
        file.write('<VTKFile type="UnstructuredGrid" byte_order="LittleEndian"><UnstructuredGrid>'
                   f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}"><Points>'
                   '<DataArray Name="Points" type="Float64" format="ascii" NumberOfComponents="3">'
                   + " ".join(f"{x!r} {y!r} {z!r}" for x, y, z in points) + "</DataArray></Points><Cells>"
                   + "".join(f'<DataArray Name="{name}" type="{word}" format="ascii">{" ".join(map(str, values))}</DataArray>'
                             for name, word, values in (("connectivity", "Int32", [i for cell in cells for i in cell]),
                                                        ("offsets", "Int32", [len(cells[0]) * (i + 1) for i in range(len(cells))]),
                                                        ("types", "UInt8", len(cells) * [kind])))
                   + '</Cells><PointData><DataArray Name="velocity" type="Float64" format="ascii" NumberOfComponents="3">'
                   + " ".join(3 * len(points) * ["0"]) + "</DataArray></PointData></Piece></UnstructuredGrid></VTKFile>")


def write_disc(path, radii):
    """Tetrahedra between the axis and a rim with one point in the middle of each sector."""
    angles = [2. * math.pi * (k + 0.5) / len(radii) - math.pi for k in range(len(radii))]
    points = [(0., 0., 0.), (0., 0., 0.02)] + [(r * math.cos(a), r * math.sin(a), 0.) for r, a in zip(radii, angles)]
    cells = [(0, 2 + k, 2 + (k + 1) % len(radii), 1) for k in range(len(radii))]
    write_cells(path, points, cells, 10)


def write_run(folder):
    os.mkdir(folder)
    with open(os.path.join(folder, "parameters.prm"), "w") as file:
        file.write(f"set Mesh size = {SIZE}\n")
    # Round at the start, toothed at the end.
    write_disc(os.path.join(folder, "a.vtu"), N_SECTORS * [RADIUS])
    write_disc(os.path.join(folder, "b.vtu"), N_SECTORS // 2 * [RADIUS + TOOTH, RADIUS - TOOTH])
    with open(os.path.join(folder, "solution.pvd"), "w") as file:
        file.write('<VTKFile type="Collection"><Collection><DataSet timestep="0" part="0" file="a.vtu"/>'
                   '<DataSet timestep="1" part="0" file="b.vtu"/></Collection></VTKFile>')
    times = [0.1 * k for k in range(1, 11)]
    with open(os.path.join(folder, "statistics"), "w") as file:
        file.write("# 1: Time (s)\n# 2: spread (m)\n# 3: spread 90 (m)\n")
        file.writelines(f"{time!r} 0.2 {0.2 + (JUMP if time > JUMP_TIME else 0.)!r}\n" for time in times)


def check_floor(directory):
    """A transparent floor is seen as a whole, 7 % of the picture where the disc leaves it free."""
    if not importlib.util.find_spec("vtkmodules") or not shutil.which("xvfb-run"):
        print("render.py is not tested: no VTK for Python, or no xvfb-run")
        return
    import matplotlib.image
    corners = [(x, y, 0.) for x, y in ((-0.2, -0.2), (0.2, -0.2), (0.2, 0.2), (-0.2, 0.2))]
    write_cells(os.path.join(directory, "disc", "walls.vtu"), corners, [(0, 1, 2), (0, 2, 3)], 5)
    process = subprocess.run(["xvfb-run", "-a", sys.executable, "-B", os.path.join(CONTRIB, "plot", "render.py"), "disc",
                              "--times", "0", "--to", "disc.png"], cwd=directory, env=ENVIRONMENT, text=True,
                             stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    check("render.py draws the disc", process.returncode == 0, process.stderr)
    picture = matplotlib.image.imread(os.path.join(directory, "disc.png"))[..., :3]
    is_grey = (picture.max(axis=2) - picture.min(axis=2) < 0.02) & (abs(picture.mean(axis=2) - 0.76) < 0.03)
    share = is_grey.mean()
    check("and the whole floor below it", share > 0.05, share)


def main(directory):
    write_run(os.path.join(directory, "disc"))
    process = run_script(directory, "plot/rim.py", "disc", "--labels", "a disc", "--times", "0", "1", "--to", "rim.png")
    check("it draws rims", process.returncode == 0 and not process.stderr
          and is_drawing(os.path.join(directory, "rim.png")), process.stderr)
    rows = [row.split(" | ") for row in process.stdout.splitlines() if row.startswith("a disc")]
    check("a round rim has no deviation, and the jump after it is found",
          rows[0] == ["a disc", "10", "0", f"{2. * RADIUS:.4f}", "0.000", "0.00", f"{JUMP / SIZE:.2f}"], rows)
    check("teeth have that of their height, and no step is after the end",
          rows[1] == ["a disc", "10", "1", f"{2. * RADIUS:.4f}", f"{TOOTH / SIZE:.3f}", f"{2. * TOOTH / SIZE:.2f}", "–"], rows)
    for what, words, *arguments in (("labels of other number", ("--labels", "allowed"), "disc", "--labels", "a", "b"),
                                    ("a run that is not there", ("nowhere",), "nowhere")):
        check(what + " is refused", is_refused(run_script(directory, "plot/rim.py", *arguments), *words))
    check_floor(directory)


if not all(importlib.util.find_spec(name) for name in ("numpy", "matplotlib")):
    sys.exit(SKIPPED)
with tempfile.TemporaryDirectory() as parent:
    main(parent)
sys.exit(1 if failed else 0)
