#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections of a run in space by a plane: the fluid in it coloured by a field, and its contour as text.

    contrib/plot/section.py output-bentonite-a-3d --plane y=0 --times 0.2 0.4 --to section.png --text section.txt
    contrib/plot/section.py output --origin 0 0 0.1 --normal 1 0 1 --field pressure

The text has a block for every polyline: a head with the time, then the coordinates in the plane and x, y, z. Needs VTK
(Debian: python3-vtk9), numpy and matplotlib.
"""

import argparse
import pathlib

import numpy as np

from figure_style import INK, WIDTH, plt, save, use_style
from lahar_output import OutputError, nearest_snapshots, read_pvd, run_script
from vtk_output import load_vtk, read_joined

UNITS = {"speed": "m/s", "velocity": "m/s", "pressure": "Pa", "strain_rate": "1/s", "effective_viscosity": "Pa s"}


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", type=pathlib.Path, help="output directory of a run in space")
    parser.add_argument("--plane", help="a plane normal to a coordinate, such as y=0 (the default) or x=0.1")
    parser.add_argument("--origin", type=float, nargs=3, default=[0., 0., 0.], help="a point of any plane, with --normal, m")
    parser.add_argument("--normal", type=float, nargs=3, help="normal of any plane, instead of --plane")
    parser.add_argument("--times", type=float, nargs="+", help="times in s (default: the first, a middle and the last)")
    parser.add_argument("--field", default="speed", help="what colours the fluid: speed (default), pressure, strain_rate ...")
    parser.add_argument("--over", type=pathlib.Path, help="output directory of a run in the plane, drawn as a line on top")
    parser.add_argument("--limits", type=float, nargs=4, metavar=("LEFT", "RIGHT", "LOW", "HIGH"), help="of the picture, m")
    parser.add_argument("--to", type=pathlib.Path, default=pathlib.Path("section.png"), help="the picture (default: section.png)")
    parser.add_argument("--text", type=pathlib.Path, help="a text file for the contour")
    return parser.parse_args()


class Plane:
    """A plane and its axes; of a plane normal to a coordinate they are the other two coordinates, in their order."""

    def __init__(self, arguments):
        if arguments.normal and arguments.plane:
            raise OutputError("both --plane and --normal are given")
        if arguments.normal:
            self.origin, self.normal = np.array(arguments.origin), np.array(arguments.normal)
            if not np.any(self.normal):
                raise OutputError("the normal of the plane is zero")
            self.normal = self.normal / np.linalg.norm(self.normal)
        else:
            self.origin, self.normal = self.parse(arguments.plane or "y=0")
        first, second = [d for d in range(3) if d != np.argmax(abs(self.normal))]
        unit = np.eye(3)
        axis = unit[first] - self.normal[first] * self.normal
        self.axes = [axis / np.linalg.norm(axis)]
        other = np.cross(self.normal, self.axes[0])
        self.axes.append(other * np.sign(other[second]))
        self.labels = ["xyz"[d] + (" (m)" if unit[d] @ a > 1 - 1e-12 else " along the plane (m)")
                       for d, a in zip((first, second), self.axes)]

    @staticmethod
    def parse(text):
        name, _, value = text.partition("=")
        try:
            normal = np.eye(3)["xyz".index(name.strip())] if len(name.strip()) == 1 else None
            return float(value) * normal, normal
        except (ValueError, TypeError):
            raise OutputError(f"--plane must read x=..., y=... or z=... in m, not '{text}'") from None

    def project(self, points):
        """Coordinates along the plane, zero nearest to the origin of space."""
        return np.stack([points @ axis for axis in self.axes], axis=-1)


class Section:
    """What a plane cuts out of a snapshot: polygons with values and the contour as polylines, all in space."""

    def __init__(self, vtk, path, plane, field):
        from vtkmodules.util.numpy_support import vtk_to_numpy
        cut_plane = vtk.vtkPlane()
        cut_plane.SetOrigin(*plane.origin)
        cut_plane.SetNormal(*plane.normal)
        cutter = vtk.vtkCutter()
        cutter.SetCutFunction(cut_plane)
        cutter.SetInputData(read_joined(vtk, path))
        clean = vtk.vtkCleanPolyData()
        clean.SetInputConnection(cutter.GetOutputPort())
        clean.PointMergingOn()
        clean.Update()
        data = clean.GetOutput()
        self.polygons, self.values, self.contour = [], np.array([]), contour_of(vtk, clean)
        if data.GetNumberOfCells() == 0:
            return
        points = vtk_to_numpy(data.GetPoints().GetData())
        corners = [[data.GetCell(c).GetPointId(i) for i in range(data.GetCell(c).GetNumberOfPoints())]
                   for c in range(data.GetNumberOfCells())]
        self.polygons = [points[cell] for cell in corners]
        name = "velocity" if field == "speed" else field
        by_point, by_cell = data.GetPointData().GetArray(name), data.GetCellData().GetArray(name)
        if not by_point and not by_cell:
            raise OutputError(f"{path}: no field '{field}'")
        array = vtk_to_numpy(by_point or by_cell).astype(float)
        if array.ndim > 1:
            array = np.linalg.norm(array, axis=1)
        self.values = np.array([array[cell].mean() for cell in corners]) if by_point else array


def contour_of(vtk, surface):
    """The boundary of the output of a filter, as polylines."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    edges = vtk.vtkFeatureEdges()
    edges.SetInputConnection(surface.GetOutputPort())
    edges.BoundaryEdgesOn()
    edges.FeatureEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.ManifoldEdgesOff()
    strips = vtk.vtkStripper()
    strips.SetInputConnection(edges.GetOutputPort())
    strips.JoinContiguousSegmentsOn()
    strips.Update()
    data = strips.GetOutput()
    if data.GetNumberOfCells() == 0:
        return []
    points = vtk_to_numpy(data.GetPoints().GetData())
    return [points[[data.GetCell(c).GetPointId(i) for i in range(data.GetCell(c).GetNumberOfPoints())]]
            for c in range(data.GetNumberOfCells())]


def contour_in_plane(vtk, path):
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(read_joined(vtk, path))
    return [line[:, :2] for line in contour_of(vtk, surface)]


def write_text(path, sections, plane):
    with open(path, "w") as file:
        file.write(f"# plane through ({', '.join(f'{x + 0.:g}' for x in plane.origin)}) m with the normal "
                   f"({', '.join(f'{x:g}' for x in plane.normal)})\n# {plane.labels[0]}, {plane.labels[1]}, x (m), y (m), z (m)\n")
        for time, section in sections:
            for line in section.contour:
                file.write(f"\n# t = {time:g} s\n")
                for inside, point in zip(plane.project(line), line):
                    file.write(" ".join(f"{value:.9g}" for value in (*inside, *point)) + "\n")
    print(f"Wrote {path}")


def draw(sections, over, plane, arguments):
    use_style()
    from matplotlib.collections import PolyCollection
    values = np.concatenate([section.values for _, section in sections])
    limits = arguments.limits
    if not limits:
        corners = np.concatenate([plane.project(polygon) for _, section in sections for polygon in section.polygons])
        low, high = corners.min(axis=0), corners.max(axis=0)
        margin = 0.03 * (high - low).max()
        limits = [low[0] - margin, high[0] + margin, low[1] - margin, high[1] + margin]
    ratio = (limits[3] - limits[2]) / (limits[1] - limits[0])
    figure, panels = plt.subplots(len(sections), 1, squeeze=False, sharex=True, layout="constrained",
                                  figsize=(WIDTH, len(sections) * (0.8 * WIDTH * ratio + 0.22) + 0.4))
    for axes, (time, section), lines in zip(panels[:, 0], sections, over):
        drawn = PolyCollection([plane.project(polygon) for polygon in section.polygons], array=section.values, cmap="viridis",
                               edgecolors="face", linewidths=0.2)
        drawn.set_clim(values.min(), values.max())
        axes.add_collection(drawn)
        for i, line in enumerate(lines):
            axes.plot(*line.T, color="#D55E00", linewidth=1., label="in the plane" if i == 0 else None)
        if lines and axes is panels[0, 0]:
            axes.legend(loc="upper right")
        axes.set(xlim=limits[:2], ylim=limits[2:], aspect="equal", ylabel=plane.labels[1])
        axes.set_title(f"t = {time:g} s", loc="left", color=INK)
    panels[-1, 0].set_xlabel(plane.labels[0])
    unit = UNITS.get(arguments.field)
    figure.colorbar(drawn, ax=panels[:, 0].tolist(), label=arguments.field.replace("_", " ") + (f" ({unit})" if unit else ""),
                    pad=0.01, fraction=0.03)
    save(figure, arguments.to)


def main():
    arguments = parse_arguments()
    vtk, plane = load_vtk(), Plane(arguments)
    snapshots = read_pvd(arguments.output / "solution.pvd")
    last = len(snapshots) - 1
    chosen = (nearest_snapshots(snapshots, arguments.times) if arguments.times
              else [snapshots[i] for i in sorted({0, last // 4, last})])
    sections = [(time, Section(vtk, path, plane, arguments.field)) for time, path in chosen]
    if not any(section.polygons for _, section in sections):
        raise OutputError("the plane does not meet the fluid")
    over = [[] for _ in chosen]
    if arguments.over:
        others = read_pvd(arguments.over / "solution.pvd")
        over = [contour_in_plane(vtk, nearest_snapshots(others, [time])[0][1]) for time, _ in chosen]
    draw(sections, over, plane, arguments)
    if arguments.text:
        write_text(arguments.text, sections, plane)


if __name__ == "__main__":
    run_script(main)
