#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps of runs in space: the depth of the fluid, measured upwards, at several times over contour lines of the ground.

    contrib/plot/depth_map.py output-landslide --times 0 10 20 30 --cell 30 --contours 25 --to landslide.png
    contrib/plot/depth_map.py output-landslide --peak peak.asc --origin 431000 5212000     # the largest depth, for a GIS

The depth of a cell of the map is the volume of fluid above it over its area; tetrahedra are divided among cells by points
inside them. Coordinates are those of the run; a grid gets the --origin that the case subtracts added again.
"""
import argparse
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

from figure_style import save, use_style  # noqa: E402
from lahar_output import OutputError, nearest_snapshots, read_pvd, read_vtu, run_script  # noqa: E402

DIVISIONS = 4  # of an edge; a tetrahedron's volume goes in equal parts to 20 points inside it


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", type=pathlib.Path, help="output directory of a run in space")
    parser.add_argument("--times", type=float, nargs="+", help="times in s (default: the first, a middle and the last)")
    parser.add_argument("--to", type=pathlib.Path, default=pathlib.Path("depth.png"), help="the picture (default: depth.png)")
    parser.add_argument("--cell", type=float, help="of the map, m (default: a sixtieth of the ground)")
    parser.add_argument("--contours", type=float, help="height between contour lines, m (default: about ten lines)")
    parser.add_argument("--peak", type=pathlib.Path, help="write the largest depth over all snapshots as ESRI ASCII grid")
    parser.add_argument("--origin", type=float, nargs=2, default=(0., 0.), help="x and y that the case subtracts from its map")
    arguments = parser.parse_args()
    for name in ("cell", "contours"):
        value = getattr(arguments, name)
        if value is not None and not 0. < value < float("inf"):
            raise OutputError(f"--{name} is {value:g}; allowed: a length above 0, in m")
    return arguments


def shares():
    """Points inside a tetrahedron, all of one weight, as shares of its corners; their mean is the centroid."""
    whole = range(DIVISIONS)
    steps = np.array([(i, j, k, DIVISIONS - 1 - i - j - k) for i in whole for j in whole for k in whole
                      if i + j + k < DIVISIONS])
    return (steps + 0.25) / DIVISIONS


class DepthMap:
    """Cells of a map from the box of points; depths of meshes on it."""

    def __init__(self, lower, upper, cell):
        self.lower, self.cell = lower, cell
        self.shape = np.maximum(1, np.ceil((upper - lower) / cell).astype(int))

    def extent(self):
        upper = self.lower + self.cell * self.shape
        return self.lower[0], upper[0], self.lower[1], upper[1]

    def depth(self, mesh):
        """Of the fluid, m, by row along y and column along x; nan where there is none."""
        corners = mesh.points[mesh.cells]
        volume = abs(np.linalg.det(corners[:, 1:] - corners[:, :1])) / 6.
        inside = shares()
        places = np.floor((np.einsum("pk,ckd->cpd", inside, corners)[..., :2] - self.lower) / self.cell).astype(int)
        weights = np.repeat(volume / len(inside), len(inside))
        places = places.reshape(-1, 2)
        known = ((places >= 0) & (places < self.shape)).all(axis=1)
        depth = np.zeros(self.shape[::-1])
        np.add.at(depth, (places[known, 1], places[known, 0]), weights[known] / self.cell**2)
        return np.where(depth > 0., depth, np.nan)

    def write(self, path, values, origin):
        """An ESRI ASCII grid."""
        with open(path, "w") as file:
            file.write(f"ncols {self.shape[0]}\nnrows {self.shape[1]}\nxllcorner {self.lower[0] + origin[0]:.10g}\n"
                       f"yllcorner {self.lower[1] + origin[1]:.10g}\ncellsize {self.cell:g}\nNODATA_value -9999\n")
            for row in np.nan_to_num(values, nan=-9999.)[::-1]:
                file.write(" ".join(f"{value:.4g}" for value in row) + "\n")


def contour_levels(lowest, highest, step):
    """Heights of contour lines, multiples of the step, without one of a tenth of the range; none on flat ground."""
    step = step or float(f"{(highest - lowest) / 10.:.1g}")
    return np.arange(np.ceil(lowest / step), highest / step) * step if step > 0. else np.zeros(0)


def main():
    arguments = parse_arguments()
    use_style()
    snapshots = read_pvd(arguments.output / "solution.pvd")
    if not snapshots:
        raise OutputError(f"{arguments.output}/solution.pvd: no snapshot; allowed: a run with one snapshot or more")
    times = arguments.times or [snapshots[0][0], snapshots[len(snapshots) // 2][0], snapshots[-1][0]]
    walls_path = arguments.output / "walls.vtu"
    if not walls_path.is_file():
        raise OutputError(f"{walls_path}: there are no walls that stand still, and so no ground")
    ground = read_vtu(walls_path, 3)
    lower, upper = ground.points.min(axis=0), ground.points.max(axis=0)
    grid = DepthMap(lower[:2], upper[:2], arguments.cell or (upper - lower)[:2].max() / 60.)

    chosen = nearest_snapshots(snapshots, times)
    depths = [grid.depth(read_vtu(path, 3)) for _, path in chosen]
    deepest = np.fmax.reduce(depths, axis=None)
    if not deepest > 0.:
        raise OutputError(f"{arguments.output}: no fluid above the ground at these times; allowed: times with some")
    levels = contour_levels(lower[2], upper[2], arguments.contours)
    width = 2.6
    size = (upper - lower)[:2]
    figure, axes = plt.subplots(1, len(chosen), figsize=(width * len(chosen) + 0.9, width * size[1] / size[0] + 0.5),
                                sharey=True, squeeze=False, constrained_layout=True)
    for axis, (time, _), depth in zip(axes[0], chosen, depths):
        if len(levels) > 0:
            lines = axis.tricontour(ground.points[:, 0], ground.points[:, 1], ground.cells, ground.points[:, 2],
                                    levels=levels, colors="0.55", linewidths=0.5)
            axis.clabel(lines, lines.levels[::4], fontsize=6, fmt="%g")
        image = axis.imshow(depth, origin="lower", extent=grid.extent(), cmap="YlOrBr", vmin=0., vmax=deepest, alpha=0.85)
        axis.set_aspect("equal")
        axis.set_title(f"t = {time:.3g} s")
        axis.set_xlabel("x (m)")
    axes[0][0].set_ylabel("y (m)")
    figure.colorbar(image, ax=axes[0].tolist(), label="depth (m)", shrink=0.8)
    save(figure, arguments.to)
    if arguments.peak:
        peak = np.zeros(grid.shape[::-1])
        for _, path in snapshots:
            peak = np.fmax(peak, grid.depth(read_vtu(path, 3)))
        grid.write(arguments.peak, np.where(peak > 0., peak, np.nan), arguments.origin)


if __name__ == "__main__":
    run_script(main)
