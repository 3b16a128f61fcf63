#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the grids of prm/landslide: the ground, terrain.asc, and the depth of what slides, release.asc.

    contrib/terrain/example_grids.py prm/landslide

The ground is a valley beside the Jacksboro Fault, Tennessee, from the elevations that matplotlib ships as sample data
(jacksboro_fault_dem.npz; Debian: python-matplotlib-data), whole metres in cells of 3 arc seconds. They are taken to cells
of 50 m, bilinearly; the origin is the middle of the first one. What slides is invented.
"""
import pathlib
import sys

import matplotlib
import numpy as np

SAMPLE = "sample_data/jacksboro_fault_dem.npz"
ROWS, COLUMNS = slice(135, 155), slice(200, 220)  # of the sample, from the north
CELL = 50.  # m
METRES = 111195.  # of a degree of a meridian
CENTRE, RADIUS, DEPTH = (720., 1100.), 250., 60.  # of what slides, m


def write_grid(path, x, y, values, digits):
    """An ESRI ASCII grid of values on the points of x and y, which ascend; rows are those of y."""
    with open(path, "w") as file:
        file.write(f"ncols {len(x)}\nnrows {len(y)}\nxllcenter {x[0]:g}\nyllcenter {y[0]:g}\ncellsize {CELL:g}\n"
                   "NODATA_value -9999\n")
        for row in values[::-1]:
            file.write(" ".join(f"{value:.{digits}f}" for value in row) + "\n")


def main():
    folder = pathlib.Path(sys.argv[1])
    sample = np.load(pathlib.Path(matplotlib.get_data_path()) / SAMPLE)
    elevation = sample["elevation"][ROWS, COLUMNS][::-1].astype(float)  # from the south
    latitude = 0.5 * (sample["ymin"] + sample["ymax"])
    x = np.arange(elevation.shape[1]) * float(sample["dx"]) * METRES * np.cos(np.radians(latitude))
    y = np.arange(elevation.shape[0]) * float(sample["dy"]) * METRES
    new_x, new_y = np.arange(0., x[-1], CELL), np.arange(0., y[-1], CELL)
    along_x = np.array([np.interp(new_x, x, row) for row in elevation])
    ground = np.array([np.interp(new_y, y, column) for column in along_x.T]).T
    write_grid(folder / "terrain.asc", new_x, new_y, ground, 1)

    distance = np.hypot(new_x[None, :] - CENTRE[0], new_y[:, None] - CENTRE[1])
    write_grid(folder / "release.asc", new_x, new_y, DEPTH * np.maximum(0., 1. - (distance / RADIUS)**2), 1)


if __name__ == "__main__":
    main()
