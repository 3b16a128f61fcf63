#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""contrib/plot/depth_map.py on files of a fluid that is known: columns of given depths on sloping ground, each as wide as
a cell of the map, and one tetrahedron over many cells. The largest depths in the grid are those of the columns, volume
and centre of the tetrahedron are its own. Wrong input is refused in one line with status 2.

Usage: depth_map.py. Exit status 77 (skipped) without numpy or matplotlib.
"""
import importlib.util
import os
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, ".."), HERE]
from program_test import check, failed
from scripts import SKIPPED, is_drawing, is_refused, run_script

SCRIPT = "plot/depth_map.py"
TRIANGLE, TETRAHEDRON = 5, 10
N_X, N_Y = 4, 3  # cells of the map, 1 m wide
ORIGIN = 431000., 5212000.
CUBE = ((0, 1, 3, 7), (0, 1, 5, 7), (0, 2, 3, 7), (0, 2, 6, 7), (0, 4, 5, 7), (0, 4, 6, 7))  # by bits z, y, x of a corner


def write_vtu(path, kind, points, cells, speed=0., pressure=lambda point: 0.):
    def array(name, type_name, values, more=""):
        return f'<DataArray Name="{name}" type="{type_name}" format="ascii"{more}>{" ".join(map(str, values))}</DataArray>'

    with open(path, "w") as file:
        file.write(f'<VTKFile type="UnstructuredGrid" byte_order="LittleEndian"><UnstructuredGrid>'
                   f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}"><Points>'
                   + array("Points", "Float64", [x for point in points for x in point], ' NumberOfComponents="3"')
                   + "</Points><Cells>" + array("connectivity", "Int32", [i for cell in cells for i in cell])
                   + array("offsets", "Int32", [len(cell) * (i + 1) for i, cell in enumerate(cells)])
                   + array("types", "UInt8", [kind] * len(cells)) + "</Cells><PointData>"
                   + array("velocity", "Float64", len(points) * [0.6 * speed, 0., -0.8 * speed], ' NumberOfComponents="3"')
                   + array("pressure", "Float64", map(pressure, points))
                   + "</PointData></Piece></UnstructuredGrid></VTKFile>")


def write_run(directory, name, height, snapshots, solid=None):
    """An output directory: ground of this height(x, y), and snapshots (points, cells) one second apart, in which the fluid
    has a speed of 1, 2, … m/s and a pressure of −1000 Pa per metre of x, and a solid (points, cells) if there is one."""
    folder = os.path.join(directory, name)
    os.mkdir(folder)
    write_vtu(os.path.join(folder, "walls.vtu"), TRIANGLE, [(x, y, height(x, y)) for x in (0., N_X) for y in (0., N_Y)],
              [(0, 2, 1), (1, 2, 3)])
    for k, snapshot in enumerate(snapshots):
        write_vtu(os.path.join(folder, f"solution-{k:05}.vtu"), TETRAHEDRON, *snapshot, k + 1., lambda point: -1e3 * point[0])
    if solid:
        write_vtu(os.path.join(folder, "solid-00000.vtu"), TETRAHEDRON, *solid)
    with open(os.path.join(folder, "solution.pvd"), "w") as file:
        file.write('<VTKFile type="Collection"><Collection>' + "".join(
            f'<DataSet timestep="{k}" part="0" file="solution-{k:05}.vtu"/>' for k in range(len(snapshots)))
            + ('<DataSet timestep="0" part="1" file="solid-00000.vtu"/>' if solid else "") + "</Collection></VTKFile>")


def slope(x, y):
    return 100. - 0.5 * x + 0.25 * y


def columns(depths):
    """Fluid of the depths by cell (i, j) of the map, on the slope."""
    points, cells = [], []
    for (i, j), depth in depths.items():
        cells += [[len(points) + corner for corner in cell] for cell in CUBE]
        points += [(x, y, slope(x, y) + z) for z in (0., depth) for y in (j, j + 1) for x in (i, i + 1)]
    return points, cells


def read_grid(path):
    """The head of an ESRI ASCII grid, and its values by cell (i, j), without those of no data."""
    with open(path) as file:
        lines = [line.split() for line in file]
    head = {line[0]: float(line[1]) for line in lines[:6]}
    rows = [[float(word) for word in line] for line in lines[:5:-1]]
    return head, {(i, j): value for j, row in enumerate(rows) for i, value in enumerate(row)
                  if value != head["NODATA_value"]}


def test_columns(directory):
    first, second = {(0, 0): 2., (1, 0): 0.5, (3, 2): 1.25}, {(1, 0): 0.75, (3, 2): 1., (2, 1): 0.1}
    write_run(directory, "columns", slope, [columns(first), columns(second)], columns({(2, 2): 1.}))
    projection = os.path.join(directory, "terrain.prj")
    with open(projection, "w") as file:
        file.write("a projection")
    process = run_script(directory, SCRIPT, "columns", "--cell", "1", "--to", "columns.png", "--rasters", "maps",
                         "--summary", "summary.png", "--least", "0.2", "--projection", projection, "--origin", *map(str, ORIGIN))
    check("it draws the map", process.returncode == 0 and not process.stderr
          and is_drawing(os.path.join(directory, "columns.png")), process.stderr)

    check("it draws the rasters", is_drawing(os.path.join(directory, "summary.png")))

    def is_raster(name, exact, tolerance):
        head, values = read_grid(os.path.join(directory, "maps", name + ".asc"))
        check(name + " lies where the map does", head == {
            "ncols": N_X, "nrows": N_Y, "xllcorner": ORIGIN[0], "yllcorner": ORIGIN[1], "cellsize": 1.,
            "NODATA_value": -9999.}, head)
        check(name + " is that of the columns", values.keys() == exact.keys()
              and all(abs(values[cell] - exact[cell]) <= tolerance * exact[cell] for cell in exact), values)
        with open(os.path.join(directory, "maps", name + ".prj")) as file:
            check(name + " has the terrain's projection", file.read() == "a projection")

    wet = {**first, **second}
    is_raster("largest_depth", {cell: max(first.get(cell, 0.), second.get(cell, 0.)) for cell in wet}, 1e-3)
    is_raster("largest_speed", {cell: 2. if cell in second else 1. for cell in wet}, 1e-3)
    # Of the points inside tetrahedra the farthest along x is a quarter of a division, of which there are four, inside.
    is_raster("largest_pressure", {(i, j): 1e3 * (i + 1. - 1. / 16.) for i, j in wet}, 1e-3)
    is_raster("arrival_time", {cell: 0. if cell in first else 1. for cell in wet if max(
        first.get(cell, 0.), second.get(cell, 0.)) >= 0.2}, 0.)
    is_raster("deposit", second, 1e-3)


def test_tetrahedron(directory):
    corners = [(0.1, 0.2, 100.), (1.5, 1.1, 103.), (0.4, 2.9, 101.), (3.9, 0.3, 99.)]
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = ([x - x0 for x, x0 in zip(corner, corners[0])] for corner in corners[1:])
    volume = abs(ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx)) / 6.
    cell = 0.01
    write_run(directory, "tetrahedron", slope, [(corners, [(0, 1, 2, 3)])])
    process = run_script(directory, SCRIPT, "tetrahedron", "--cell", str(cell), "--rasters", ".")
    check("it draws one tetrahedron", process.returncode == 0, process.stderr)
    _, values = read_grid(os.path.join(directory, "deposit.asc"))
    total = sum(values.values())
    check("the sum of depth times area is its volume", abs(total * cell**2 / volume - 1.) < 1e-3, total * cell**2, volume)
    for d, name in enumerate("xy"):
        mean = sum(value * (place[d] + 0.5) * cell for place, value in values.items()) / total
        exact = sum(corner[d] for corner in corners) / 4.
        check(f"the centre is its own along {name}", abs(mean - exact) < 0.5 * cell, mean, exact)


def test_special(directory):
    write_run(directory, "flat", lambda x, y: 0., [columns({(0, 0): 1.})])
    process = run_script(directory, SCRIPT, "flat", "--to", "flat.png")
    check("flat ground has a map without contour lines", process.returncode == 0 and not process.stderr
          and is_drawing(os.path.join(directory, "flat.png")), process.stderr)
    write_run(directory, "empty", slope, [])
    write_run(directory, "beside", slope, [([(x + 50., y, z) for x, y, z in columns({(0, 0): 1.})[0]], CUBE)])
    write_run(directory, "no_ground", slope, [columns({(0, 0): 1.})])
    os.remove(os.path.join(directory, "no_ground", "walls.vtu"))
    for what, words, *arguments in (("a run without a snapshot", ("solution.pvd", "allowed"), "empty"),
                                    ("fluid beside the ground", ("no fluid", "allowed"), "beside"),
                                    ("a run without ground", ("walls.vtu",), "no_ground"),
                                    ("a run that is not there", ("nowhere",), "nowhere"),
                                    ("a cell of no size", ("--cell", "allowed"), "flat", "--cell", "0"),
                                    ("contours of no distance", ("--contours", "allowed"), "flat", "--contours", "-1"),
                                    ("a negative depth", ("--least", "allowed"), "flat", "--least", "-1")):
        process = run_script(directory, SCRIPT, *arguments, "--to", "refused.png")
        check(f"{what} is refused", is_refused(process, *words), process.returncode, process.stderr)


def main():
    if not importlib.util.find_spec("numpy") or not importlib.util.find_spec("matplotlib"):
        print("not tested: numpy or matplotlib is missing")
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as directory:
        test_columns(directory)
        test_tetrahedron(directory)
        test_special(directory)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
