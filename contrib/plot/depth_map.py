#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps of runs in space: the depth of the fluid, measured upwards, at several times over contour lines of the ground.

    contrib/plot/depth_map.py output-landslide --times 0 10 20 30 --cell 30 --contours 25 --to landslide.png
    contrib/plot/depth_map.py output-landslide --rasters maps --origin 431000 5212000     # for a GIS
    contrib/plot/depth_map.py output-barrier --rasters maps --summary summary.png         # and a picture of them

The depth of a cell of the map is the volume of fluid above it over its area; tetrahedra are divided among cells by points
inside them. Coordinates are those of the run; a raster gets the --origin that the case subtracts added again. Solids are
drawn where they stand.

The rasters of --rasters are ESRI ASCII grids made of all snapshots, without a value where there never was fluid:

    largest_depth.asc       m
    largest_speed.asc       m/s, of the mean over the depth of the speed
    largest_pressure.asc    Pa, of the largest one over the depth, positive where the fluid pushes
    arrival_time.asc        s, of the first snapshot in which the fluid is at least --least deep; others have no value
    deposit.asc             m, the depth in the last snapshot
"""
import argparse
import pathlib
import shutil

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402

from figure_style import save, use_style  # noqa: E402
from lahar_output import OutputError, nearest_snapshots, read_pvd, read_vtu, run_script  # noqa: E402
from mesh_geometry import outside  # noqa: E402

DIVISIONS = 4  # of an edge; a tetrahedron's volume goes in equal parts to 20 points inside it


# Of the rasters in the picture of --summary: the label, the factor of its unit and the colours.
SUMMARY = {"largest_depth": ("largest depth (m)", 1., "YlOrBr"), "largest_speed": ("largest speed (m/s)", 1., "viridis"),
           "largest_pressure": ("largest pressure (kPa)", 1e-3, "magma_r"), "arrival_time": ("arrival (s)", 1., "cividis"),
           "deposit": ("deposit (m)", 1., "YlOrBr")}


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", type=pathlib.Path, help="output directory of a run in space")
    parser.add_argument("--times", type=float, nargs="+", help="times in s (default: the first, a middle and the last)")
    parser.add_argument("--to", type=pathlib.Path, default=pathlib.Path("depth.png"), help="the picture (default: depth.png)")
    parser.add_argument("--cell", type=float, help="of the map, m (default: a sixtieth of the ground)")
    parser.add_argument("--contours", type=float, help="height between contour lines, m (default: about ten lines)")
    parser.add_argument("--rasters", type=pathlib.Path, help="directory for rasters made of all snapshots")
    parser.add_argument("--summary", type=pathlib.Path, help="a picture of the rasters of all snapshots, side by side")
    parser.add_argument("--least", type=float, default=0., help="depth with which the fluid has arrived, m (default: any)")
    parser.add_argument("--projection", type=pathlib.Path, help=".prj file of the terrain; each raster gets a copy")
    parser.add_argument("--origin", type=float, nargs=2, default=(0., 0.), help="x and y that the case subtracts from its map")
    arguments = parser.parse_args()
    for name in ("cell", "contours"):
        value = getattr(arguments, name)
        if value is not None and not 0. < value < float("inf"):
            raise OutputError(f"--{name} is {value:g}; allowed: a length above 0, in m")
    if not 0. <= arguments.least < float("inf"):
        raise OutputError(f"--least is {arguments.least:g}; allowed: a depth of 0 or more, in m")
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

    def parts(self, mesh):
        """Of the parts of tetrahedra that lie above the map: the cell's row along y and column along x, the volume, the
        index of the tetrahedron and the shares of its corners in a field's value there."""
        corners = mesh.points[mesh.cells]
        volume = abs(np.linalg.det(corners[:, 1:] - corners[:, :1])) / 6.
        inside = shares()
        places = np.floor((np.einsum("pk,ckd->cpd", inside, corners)[..., :2] - self.lower) / self.cell).astype(int)
        known = ((places >= 0) & (places < self.shape)).all(axis=2)
        cell, point = np.nonzero(known)
        return places[known][:, ::-1].T, volume[cell] / len(inside), cell, inside[point]

    def depth(self, mesh):
        """Of the fluid, m, by row along y and column along x; nan where there is none."""
        places, volumes, _, _ = self.parts(mesh)
        return self.depth_of(places, volumes)

    def depth_of(self, places, volumes):
        depth = np.zeros(self.shape[::-1])
        np.add.at(depth, tuple(places), volumes / self.cell**2)
        return np.where(depth > 0., depth, np.nan)

    def flow(self, mesh):
        """Depth, mean of the speed over it, and the largest pressure, each by row and column; nan where there is none."""
        places, volumes, cells, weights = self.parts(mesh)
        depth = self.depth_of(places, volumes)

        def there(name):
            values = mesh.at_points(name)[mesh.cells[cells]]
            return np.einsum("pk,pk...->p...", weights, values)

        speed, pressure = np.zeros(depth.shape), np.full(depth.shape, -np.inf)
        np.add.at(speed, tuple(places), np.linalg.norm(there("velocity"), axis=1) * volumes / self.cell**2)
        np.maximum.at(pressure, tuple(places), -there("pressure"))
        return depth, speed / depth, np.where(depth > 0., pressure, np.nan)

    def write(self, path, values, origin):
        """An ESRI ASCII grid."""
        with open(path, "w") as file:
            file.write(f"ncols {self.shape[0]}\nnrows {self.shape[1]}\nxllcorner {self.lower[0] + origin[0]:.10g}\n"
                       f"yllcorner {self.lower[1] + origin[1]:.10g}\ncellsize {self.cell:g}\nNODATA_value -9999\n")
            for row in np.nan_to_num(values, nan=-9999.)[::-1]:
                file.write(" ".join(f"{value:.4g}" for value in row) + "\n")


def make_rasters(grid, snapshots, arguments):
    """The rasters of --rasters by name, see above."""
    rasters = {name: np.full(grid.shape[::-1], np.nan)
               for name in ("largest_depth", "largest_speed", "largest_pressure", "arrival_time")}
    for time, path in snapshots:
        depth, speed, pressure = grid.flow(read_vtu(path, 3))
        for name, values in ("largest_depth", depth), ("largest_speed", speed), ("largest_pressure", pressure):
            rasters[name] = np.fmax(rasters[name], values)
        arrives = np.isnan(rasters["arrival_time"]) & (depth >= arguments.least)
        rasters["arrival_time"][arrives] = time
        rasters["deposit"] = depth
    return rasters


def write_rasters(grid, rasters, arguments):
    arguments.rasters.mkdir(parents=True, exist_ok=True)
    for name, values in rasters.items():
        grid.write(arguments.rasters / f"{name}.asc", values, arguments.origin)
        if arguments.projection:
            shutil.copyfile(arguments.projection, arguments.rasters / f"{name}.prj")


def contour_levels(lowest, highest, step):
    """Heights of contour lines, multiples of the step, without one of a tenth of the range; none on flat ground."""
    step = step or float(f"{(highest - lowest) / 10.:.1g}")
    return np.arange(np.ceil(lowest / step), highest / step) * step if step > 0. else np.zeros(0)


class Ground:
    """What all maps have below their colours: contour lines of the ground, and the solids on it."""

    def __init__(self, mesh, step):
        self.mesh = mesh
        self.lower, self.upper = mesh.points.min(axis=0), mesh.points.max(axis=0)
        self.levels = contour_levels(self.lower[2], self.upper[2], step)

    def draw(self, axis, solid):
        x, y, z = self.mesh.points.T
        if len(self.levels) > 0:
            lines = axis.tricontour(x, y, self.mesh.cells, z, levels=self.levels, colors="0.55", linewidths=0.5)
            axis.clabel(lines, lines.levels[::4], fontsize=6, fmt="%g")
        if solid is not None:
            faces, _ = outside(solid)
            axis.add_collection(PolyCollection(solid.points[faces][:, :, :2], facecolors="0.15", edgecolors="none", zorder=3))
        axis.set_xlim(self.lower[0], self.upper[0])
        axis.set_ylim(self.lower[1], self.upper[1])
        axis.set_aspect("equal")
        axis.set_xlabel("x (m)")

    def figure(self, n_maps, columns):
        """A figure for maps in rows of at most @p columns, and its axes."""
        columns = min(n_maps, columns)
        rows = -(-n_maps // columns)
        width, size = 2.6 if columns == n_maps else 3., (self.upper - self.lower)[:2]
        figure, axes = plt.subplots(rows, columns, figsize=(width * columns + 0.9, rows * (width * size[1] / size[0] + 0.5)),
                                    sharey=True, squeeze=False, constrained_layout=True)
        for row in axes:
            row[0].set_ylabel("y (m)")
        for axis in axes.flat[n_maps:]:
            axis.set_axis_off()
        return figure, axes


def draw_depths(grid, ground, chosen, solids, path):
    """The depths of the chosen snapshots (time, path), in one scale."""
    depths = [grid.depth(read_vtu(name, 3)) for _, name in chosen]
    deepest = np.fmax.reduce(depths, axis=None)
    if not deepest > 0.:
        raise OutputError(f"{chosen[0][1].parent}: no fluid above the ground at these times; allowed: times with some")
    figure, axes = ground.figure(len(chosen), len(chosen))
    for axis, (time, _), depth in zip(axes[0], chosen, depths):
        ground.draw(axis, solid_at(solids, time))
        image = axis.imshow(depth, origin="lower", extent=grid.extent(), cmap="YlOrBr", vmin=0., vmax=deepest, alpha=0.85)
        axis.set_title(f"t = {time:.3g} s")
    figure.colorbar(image, ax=axes[0].tolist(), label="depth (m)", shrink=0.8)
    save(figure, path)


def draw_summary(grid, ground, rasters, solid, path):
    """The rasters, each in a scale of its own, which a single cell in 200 may exceed."""
    figure, axes = ground.figure(len(rasters), 3)
    for axis, (name, values) in zip(axes.flat, rasters.items()):
        label, factor, colours = SUMMARY[name]
        ground.draw(axis, solid)
        known = values[np.isfinite(values)]
        most = factor * np.percentile(known, 99.5) if known.size else None
        image = axis.imshow(factor * values, origin="lower", extent=grid.extent(), cmap=colours, alpha=0.85, vmax=most)
        figure.colorbar(image, ax=axis, label=label, shrink=0.8, extend="max")
    save(figure, path)


def solid_at(solids, time):
    """The solids' mesh at a time; None if the run has none."""
    return read_vtu(nearest_snapshots(solids, [time])[0][1], 3) if solids else None


def main():
    arguments = parse_arguments()
    use_style()
    snapshots = read_pvd(arguments.output / "solution.pvd")
    if not snapshots:
        raise OutputError(f"{arguments.output}/solution.pvd: no snapshot; allowed: a run with one snapshot or more")
    solids = read_pvd(arguments.output / "solution.pvd", 1)
    times = arguments.times or [snapshots[0][0], snapshots[len(snapshots) // 2][0], snapshots[-1][0]]
    walls_path = arguments.output / "walls.vtu"
    if not walls_path.is_file():
        raise OutputError(f"{walls_path}: there are no walls that stand still, and so no ground")
    ground = Ground(read_vtu(walls_path, 3), arguments.contours)
    extent = (ground.upper - ground.lower)[:2].max()
    grid = DepthMap(ground.lower[:2], ground.upper[:2], arguments.cell or extent / 60.)
    draw_depths(grid, ground, nearest_snapshots(snapshots, times), solids, arguments.to)
    if arguments.rasters or arguments.summary:
        rasters = make_rasters(grid, snapshots, arguments)
        if arguments.rasters:
            write_rasters(grid, rasters, arguments)
        if arguments.summary:
            draw_summary(grid, ground, rasters, solid_at(solids, snapshots[-1][0]), arguments.summary)


if __name__ == "__main__":
    run_script(main)
