#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draw snapshots of Lahar runs: one field in colour, unyielded fluid shaded, walls dark.

    snapshots.py output-quickstart --times 0.1 0.2 0.4 -o snapshots.png --field speed
    snapshots.py output-elastic output-rigid --labels elastic rigid --field yielded -o yielded.png

Several runs stand side by side. The field "yielded" draws what has yielded black and the rest grey. The walls come from
the run, or from --walls "x, y : x, y ... ; x, y : ..."; a line that ends where it starts is a solid body, or the tank
of fluid inside it.
"""

import argparse
import math
import pathlib

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection
from matplotlib.colors import LogNorm, Normalize
from matplotlib.patches import Patch, PathPatch
from matplotlib.path import Path

from figure_style import INK, WIDTH, plt, save, use_style
from lahar_output import (OutputError, nearest_snapshots, parse_walls, read_pvd, read_vtu, read_walls, run_script)
from mesh_geometry import faces_with_cells, usual_range

LABELS = {
    "speed": "speed (m/s)", "velocity": "speed (m/s)", "pressure": "pressure (Pa)", "strain_rate": "strain rate (1/s)",
    "effective_viscosity": "effective viscosity (Pa s)", "fluid": "number of the fluid",
}
BY_CELL = ("strain_rate", "effective_viscosity", "yielded")
N_DEFAULT_PANELS = 4


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directories", type=pathlib.Path, metavar="OUTPUT_DIR", nargs="+", help="output directory of a run")
    parser.add_argument("-o", "--output", required=True, help="the picture (.png, .pdf, .svg)")
    parser.add_argument("--times", type=float, nargs="+", metavar="T",
                        help=f"times in s; the nearest snapshots are drawn (default: {N_DEFAULT_PANELS} over the run)")
    parser.add_argument("--labels", nargs="+", metavar="TEXT", help="what the runs are called")
    parser.add_argument("--field", default="speed", help="speed, or a field of the VTU files (default: %(default)s)")
    parser.add_argument("--log", action="store_true", help="logarithmic colours")
    parser.add_argument("--walls", help="draw these walls instead of the run's")
    parser.add_argument("--limits", type=float, nargs=4, metavar=("X0", "X1", "Y0", "Y1"), help="the part drawn, in m")
    parser.add_argument("--columns", type=int, help="panels side by side (default: by the shape of the flow)")
    return parser.parse_args()


# ---------------------------------------------------------------------------------------------------------- data


def choose_snapshots(directory, times):
    path = directory / "solution.pvd"
    snapshots = read_pvd(path)
    if not snapshots:
        raise OutputError(f"{path}: no snapshot")
    if times is None:
        times = np.linspace(snapshots[0][0], snapshots[-1][0], N_DEFAULT_PANELS)
    return nearest_snapshots(snapshots, times)


def field_values(mesh, name):
    """The field by point or by triangle, and the magnitude where it is a vector."""
    name = "velocity" if name == "speed" else name
    values = mesh.at_cells(name) if name in BY_CELL or name in mesh.cell_data else mesh.at_points(name)
    return values if values.ndim == 1 else np.linalg.norm(values, axis=1)


def color_scale(all_values, name, logarithmic):
    """One scale for all panels, from zero on unless the values are logarithmic or negative."""
    values = np.concatenate(all_values)
    values = values[np.isfinite(values)]
    if logarithmic:
        values = values[values > 0]
    if len(values) == 0:
        raise OutputError(f"field '{name}' has no value to draw")
    if logarithmic:
        return LogNorm(*np.exp(usual_range(np.log(values))))
    lower, upper = usual_range(values)
    lower = min(lower, 0)
    return Normalize(lower, upper if upper > lower else lower + 1)


def extension(norm, all_values):
    """The ends of the colour bar beyond which values lie."""
    is_below = min(np.nanmin(values) for values in all_values) < norm.vmin
    is_above = max(np.nanmax(values) for values in all_values) > norm.vmax
    return {(0, 0): "neither", (1, 0): "min", (0, 1): "max", (1, 1): "both"}[int(is_below), int(is_above)]


def view(meshes, walls, limits):
    """The rectangle drawn (x0, x1, y0, y1): fluid and walls with a small margin."""
    if limits:
        if limits[0] >= limits[1] or limits[2] >= limits[3]:
            raise OutputError("--limits X0 X1 Y0 Y1 needs X0 < X1 and Y0 < Y1")
        return limits
    points = np.concatenate([mesh.points for mesh in meshes] + [wall.corners for wall in walls])
    (x0, y0), (x1, y1) = points.min(axis=0), points.max(axis=0)
    margin = 0.03 * max(x1 - x0, y1 - y0)
    return x0 - margin, x1 + margin, y0 - margin, y1 + margin


# ------------------------------------------------------------------------------------------------------- drawing


def draw_field(axes, mesh, values, norm):
    if len(values) == len(mesh.triangles):
        return axes.tripcolor(*mesh.points.T, mesh.triangles, facecolors=values, norm=norm, cmap="viridis",
                              antialiased=False, rasterized=True)
    return axes.tripcolor(*mesh.points.T, mesh.triangles, values, norm=norm, cmap="viridis", shading="gouraud",
                          rasterized=True)


def draw_unyielded(axes, mesh):
    """Shade the unyielded fluid and draw the yield surface; say whether there was any."""
    if not mesh.has_field("yielded"):
        return False
    is_rigid = mesh.at_cells("yielded") < 0.5
    if not is_rigid.any():
        return False
    axes.add_patch(PathPatch(union(mesh.points[mesh.triangles[is_rigid]]), facecolor="white", alpha=0.45, linewidth=0,
                             rasterized=True))
    corners, cells, others = faces_with_cells(mesh)
    is_yield_surface = (others >= 0) & (is_rigid[cells] != is_rigid[others])
    axes.add_collection(LineCollection(mesh.points[corners[is_yield_surface]], color="white", linewidth=0.7))
    return True


def union(triangles):
    """One path around triangles turned the same way, so that what is transparent shows no seam between them."""
    edges = triangles[:, 1:] - triangles[:, :1]
    is_clockwise = edges[:, 0, 0] * edges[:, 1, 1] < edges[:, 0, 1] * edges[:, 1, 0]
    triangles = np.where(is_clockwise[:, None, None], triangles[:, ::-1], triangles)
    closed = np.concatenate([triangles, triangles[:, :1]], axis=1)
    codes = np.tile([Path.MOVETO, Path.LINETO, Path.LINETO, Path.CLOSEPOLY], len(closed))
    return Path(closed.reshape(-1, 2), codes)


def draw_outline(axes, mesh):
    corners, _, others = faces_with_cells(mesh)
    axes.add_collection(LineCollection(mesh.points[corners[others < 0]], color=INK, linewidth=0.5, capstyle="round"))


def draw_yielded(axes, mesh):
    """Yielded fluid black, the rest grey."""
    yielded = mesh.at_cells("yielded") > 0.5
    for chosen, color in ((~yielded, "0.8"), (yielded, "black")):
        axes.add_patch(PathPatch(union(mesh.points[mesh.triangles[chosen]]), facecolor=color, linewidth=0, rasterized=True))


def draw_solids(axes, mesh):
    axes.add_patch(PathPatch(union(mesh.points[mesh.triangles]), facecolor="#D55E00", linewidth=0, zorder=3))
    draw_outline(axes, mesh)


def draw_walls(axes, walls, meshes):
    """Lines; closed ones are filled unless fluid is inside in all of @p meshes: a body that moves has fluid behind it."""
    centres = [mesh.points[mesh.triangles].mean(axis=1) for mesh in meshes]
    for wall in walls:
        if wall.is_closed and not all(Path(wall.corners).contains_points(points).any() for points in centres):
            axes.fill(*wall.corners.T, facecolor="0.45", edgecolor=INK, linewidth=1.2)
        else:
            axes.plot(*wall.corners.T, color=INK, linewidth=1.8, solid_capstyle="butt", solid_joinstyle="miter")


def draw_panel(axes, mesh, solids, walls, first_mesh, field, norm):
    """Draw one snapshot; say whether unyielded fluid is paler. Closed walls around fluid of @p first_mesh are tanks."""
    has_unyielded = False
    if field == "yielded":
        draw_yielded(axes, mesh)
    else:
        draw_field(axes, mesh, field_values(mesh, field), norm)
        has_unyielded = draw_unyielded(axes, mesh)
    draw_outline(axes, mesh)
    if solids:
        draw_solids(axes, solids)
    draw_walls(axes, walls, (first_mesh, mesh))
    return has_unyielded


def make_axes(n_panels, limits, n_columns):
    """A grid of panels that is neither very flat nor very tall and has few places empty."""
    aspect = (limits[3] - limits[2]) / (limits[1] - limits[0])
    if n_columns is None:
        def badness(n):
            n_rows = math.ceil(n_panels / n)
            return abs(math.log(n_rows * aspect / n / 0.7)) + 0.5 * (n * n_rows - n_panels)
        n_columns = min(range(1, n_panels + 1), key=badness)
    n_columns = min(n_columns, n_panels)
    n_rows = math.ceil(n_panels / n_columns)
    height = n_rows * (0.86 * WIDTH / n_columns * aspect + 0.3) + 0.3
    figure, axes = plt.subplots(n_rows, n_columns, figsize=(WIDTH, height), sharex=True, sharey=True, squeeze=False,
                                layout="constrained")
    for unused in axes.flat[n_panels:]:
        unused.set_visible(False)
    return figure, axes


def label_axes(axes, n_panels):
    """Label x below every column's last panel, y beside the first column."""
    n_columns = axes.shape[1]
    for i, panel in enumerate(axes.flat[:n_panels]):
        is_last = i + n_columns >= n_panels
        panel.tick_params(top=True, right=True, labelbottom=is_last)
        panel.set_xlabel("$x$ (m)" if is_last else "")
    for panel in axes[:, 0]:
        panel.set_ylabel("$y$ (m)")


class Snapshots:
    """The chosen snapshots of one run."""

    def __init__(self, directory, arguments):
        chosen = choose_snapshots(directory, arguments.times)
        self.times = [time for time, _ in chosen]
        self.meshes = [read_vtu(path) for _, path in chosen]
        # Walls that move have a file for each snapshot.
        moving = dict(read_pvd(directory / "solution.pvd", 2))
        self.walls = [parse_walls(arguments.walls) if arguments.walls else
                      read_walls(moving.get(time, directory / "walls.vtu")) for time in self.times]
        solids = {time: path for time, path in read_pvd(directory / "solution.pvd", 1)}
        self.solids = [read_vtu(solids[time]) if time in solids else None for time in self.times]


def draw(arguments):
    runs = [Snapshots(directory, arguments) for directory in arguments.directories]
    labels = arguments.labels or [directory.name for directory in arguments.directories]
    if len({len(run.times) for run in runs}) > 1:
        raise OutputError("the runs do not have the same number of snapshots at these times")
    meshes = [mesh for run in runs for mesh in run.meshes]
    limits = view(meshes, [wall for run in runs for walls in run.walls for wall in walls], arguments.limits)
    # Row by row: one row holds all runs at one time.
    panels = [(run, label, i) for i in range(len(runs[0].times)) for run, label in zip(runs, labels)]
    figure, axes = make_axes(len(panels), limits, len(runs) if len(runs) > 1 else arguments.columns)

    is_yielded, norm = arguments.field == "yielded", None
    if not is_yielded:
        all_values = [field_values(mesh, arguments.field) for mesh in meshes]
        norm = color_scale(all_values, arguments.field, arguments.log)
    has_unyielded = False
    for panel, (run, label, i) in zip(axes.flat, panels):
        mesh = run.meshes[i]
        has_unyielded |= draw_panel(panel, mesh, run.solids[i], run.walls[i], run.meshes[0], arguments.field, norm)
        panel.set(aspect="equal", xlim=limits[:2], ylim=limits[2:],
                  title=(f"{label}, " if len(runs) > 1 else "") + f"$t$ = {run.times[i]:.4g} s")
    label_axes(axes, len(panels))
    if is_yielded:
        add_legend(axes[0, 0], ("black", "yielded"), ("0.8", "unyielded"))
    else:
        figure.colorbar(ScalarMappable(norm, "viridis"), ax=axes, label=LABELS.get(arguments.field, arguments.field),
                        extend=extension(norm, all_values), fraction=0.03, pad=0.015, aspect=25)
    if has_unyielded:
        add_legend(axes[0, 0], ("0.85", "unyielded (paler)"))
    return figure


def add_legend(axes, *entries):
    axes.legend(handles=[Patch(facecolor=color, edgecolor="0.5", linewidth=0.7, label=label) for color, label in entries],
                loc="upper right")


def main():
    arguments = parse_arguments()
    if arguments.columns is not None and arguments.columns < 1:
        raise OutputError("--columns must be 1 or more")
    if arguments.labels and len(arguments.labels) != len(arguments.directories):
        raise OutputError("--labels needs one text for each run")
    use_style()
    save(draw(arguments), arguments.output)


if __name__ == "__main__":
    run_script(main)
