#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the grids of prm/landslide: the ground, terrain.asc, and the depth of what slides, release.asc.

    contrib/terrain/example_grids.py prm/landslide

Both are functions: a slope that falls to the west, to the floor of a valley with an opposite bank, in it a channel with
bends, and bumps all over. What slides lies at the channel's upper end.
"""
import pathlib
import sys

import numpy as np

CELL, COLUMNS, ROWS = 50., 29, 36  # m
CENTRE, RADIUS, DEPTH = (1000., 875.), 250., 60.  # of what slides, m


def ground(x, y):
    """Elevations, m."""
    slope = 350. + 160. * (1. + np.tanh((x - 800.) / 350.))
    bank = 80. * np.exp(-(x / 150.)**2)
    floor = 0.03 * y  # falls to the south
    beside = y - CENTRE[1] - 90. * np.sin(2. * np.pi * (x - CENTRE[0]) / 900.)
    channel = 50. * np.exp(-((x - 800.) / 260.)**2 - 0.5 * (beside / 120.)**2)
    bumps = 4. * np.sin(2. * np.pi * x / 350.) * np.sin(2. * np.pi * y / 420.)
    return slope + bank + floor - channel + bumps


def release(x, y):
    """Depths, m: a cap."""
    return DEPTH * np.maximum(0., 1. - ((x - CENTRE[0])**2 + (y - CENTRE[1])**2) / RADIUS**2)


def write_grid(path, x, y, values):
    """An ESRI ASCII grid of values on the points of x and y, which ascend; rows are those of y."""
    with open(path, "w") as file:
        file.write(f"ncols {len(x)}\nnrows {len(y)}\nxllcenter {x[0]:g}\nyllcenter {y[0]:g}\ncellsize {CELL:g}\n"
                   "NODATA_value -9999\n")
        for row in values[::-1]:
            file.write(" ".join(f"{value:.1f}" for value in row) + "\n")


def main():
    folder = pathlib.Path(sys.argv[1])
    x, y = CELL * np.arange(COLUMNS), CELL * np.arange(ROWS)
    write_grid(folder / "terrain.asc", x, y, ground(x[None, :], y[:, None]))
    write_grid(folder / "release.asc", x, y, release(x[None, :], y[:, None]))


if __name__ == "__main__":
    main()
