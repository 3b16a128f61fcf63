#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Views of runs in space: the fluid's surface coloured by speed, solids in one colour, walls transparent, at several
times side by side.

    contrib/plot/render.py output-mini-cone --times 0 0.1 5 --to cone.png
    contrib/plot/render.py output-dam-break-elastic-3d --cut y=0.04 --to half.png    # what lies behind a plane

Needs VTK (Debian: python3-vtk9) and, where there is no display, a virtual one (xvfb-run).
"""

import argparse
import itertools
import pathlib

import numpy as np

from lahar_output import OutputError, nearest_snapshots, read_pvd, run_script
from vtk_output import load_vtk, read_joined

SOLID = (0.84, 0.37, 0.)
WALL = (0.35, 0.35, 0.38)
VIEW_ANGLE = 21.  # degrees
HEIGHT = 0.8  # of a view over its width


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", type=pathlib.Path, help="output directory of a run in space")
    parser.add_argument("--times", type=float, nargs="+", help="times in s (default: the first, a middle and the last)")
    parser.add_argument("--to", type=pathlib.Path, default=pathlib.Path("views.png"), help="the picture (default: views.png)")
    parser.add_argument("--fastest", type=float, help="speed at the end of the colour scale, m/s (default: the largest)")
    parser.add_argument("--azimuth", type=float, default=30., help="of the camera about the vertical, degrees")
    parser.add_argument("--elevation", type=float, default=25., help="of the camera above the floor, degrees")
    parser.add_argument("--cut", help="show only what lies behind a plane such as y=0.04, seen from the camera")
    parser.add_argument("--columns", type=int, help="views side by side (default: all)")
    parser.add_argument("--width", type=int, default=520, help="of one view, pixels")
    return parser.parse_args()


def direction_of_view(arguments):
    """The unit vector towards the camera."""
    azimuth, elevation = np.radians([arguments.azimuth, arguments.elevation])
    return np.array([np.cos(elevation) * np.sin(azimuth), -np.cos(elevation) * np.cos(azimuth), np.sin(elevation)])


def parse_cut(text, towards_camera):
    """The plane 'y=0.04' as origin and normal, which points away from the camera; None without one."""
    if text is None:
        return None
    axis, _, value = text.partition("=")
    normal, origin = np.zeros(3), np.zeros(3)
    try:
        d = "xyz".index(axis.strip() or "?")
        origin[d] = float(value)
    except ValueError:
        raise OutputError(f"--cut must read x=, y= or z= and a number, not '{text}'") from None
    normal[d] = -1. if towards_camera[d] > 0. else 1.
    return origin, normal


def read_surface(vtk, path, cut, feature_angle=50.):
    """The outside of a snapshot, of the part behind the plane @p cut, as smooth triangles with the field 'speed' at points."""
    mesh = read_joined(vtk, path)
    if cut is not None:
        plane = vtk.vtkPlane()
        plane.SetOrigin(*cut[0])
        plane.SetNormal(*cut[1])
        clip = vtk.vtkTableBasedClipDataSet()
        clip.SetInputData(mesh)
        clip.SetClipFunction(plane)
        clip.Update()
        mesh = clip.GetOutput()
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(mesh)
    norm = vtk.vtkArrayCalculator()
    norm.SetInputConnection(surface.GetOutputPort())
    norm.AddVectorArrayName("velocity")
    norm.SetFunction("mag(velocity)")
    norm.SetResultArrayName("speed")
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputConnection(norm.GetOutputPort())
    normals.SetFeatureAngle(feature_angle)
    normals.Update()
    return normals.GetOutput()


def read_walls(vtk, path, scene):
    """The walls as far as they stand in the scene's box, slightly enlarged; None if the run has none."""
    if not path.is_file():
        return None
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(read_joined(vtk, path))
    surface.Update()
    data = surface.GetOutput()
    for d in range(3):
        for sign in (-1., 1.):
            normal = np.zeros(3)
            normal[d] = -sign
            plane = vtk.vtkPlane()
            plane.SetOrigin(*(scene.centre + sign * (0.5 * scene.size + 0.05 * scene.extent)))
            plane.SetNormal(*normal)
            clip = vtk.vtkClipPolyData()
            clip.SetInputData(data)
            clip.SetClipFunction(plane)
            clip.Update()
            data = clip.GetOutput()
    return data


class Scene:
    """What all views share: centre, size, direction of view and colours."""

    def __init__(self, vtk, surfaces, arguments):
        self.vtk = vtk
        bounds = np.array([surface.GetBounds() for surface in surfaces])
        lower, upper = bounds[:, 0::2].min(axis=0), bounds[:, 1::2].max(axis=0)
        self.floor, self.centre, self.extent = lower[2], 0.5 * (lower + upper), (upper - lower).max()
        self.size, self.direction = upper - lower, direction_of_view(arguments)
        # The half height that holds the corners of the box around everything, as the camera sees them.
        azimuth = np.radians(arguments.azimuth)
        right = np.array([np.cos(azimuth), np.sin(azimuth), 0.])
        corners = 0.5 * (upper - lower) * np.array(list(itertools.product((-1., 1.), repeat=3)))
        self.half_height = 1.08 * max(abs(corners @ np.cross(right, -self.direction)).max(),
                                      HEIGHT * abs(corners @ right).max()) + 0.02 * self.extent
        self.colours = vtk.vtkLookupTable()
        self.colours.SetHueRange(0.62, 0.02)
        self.colours.SetSaturationRange(0.55, 0.85)
        self.colours.SetRange(0., arguments.fastest
                              or max(surface.GetPointData().GetArray("speed").GetRange()[1] for surface in surfaces))
        self.colours.Build()

    def fluid(self, surface):
        mapper = self.vtk.vtkPolyDataMapper()
        mapper.SetInputData(surface)
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray("speed")
        mapper.SetLookupTable(self.colours)
        mapper.SetScalarRange(*self.colours.GetRange())
        actor = self.vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetSpecular(0.15)
        return actor

    def solid(self, surface):
        mapper = self.vtk.vtkPolyDataMapper()
        mapper.SetInputData(surface)
        mapper.ScalarVisibilityOff()
        actor = self.vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(*SOLID)
        return actor

    def walls(self, surface):
        mapper = self.vtk.vtkPolyDataMapper()
        mapper.SetInputData(surface)
        mapper.ScalarVisibilityOff()
        actor = self.vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(*WALL)
        actor.GetProperty().SetOpacity(0.25)
        return actor

    def floor_plane(self):
        floor = self.vtk.vtkPlaneSource()
        (x, y), z, half = self.centre[:2], self.floor - 1e-3 * self.extent, 0.65 * self.extent
        floor.SetOrigin(x - half, y - half, z)
        floor.SetPoint1(x + half, y - half, z)
        floor.SetPoint2(x - half, y + half, z)
        mapper = self.vtk.vtkPolyDataMapper()
        mapper.SetInputConnection(floor.GetOutputPort())
        actor = self.vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(0.92, 0.92, 0.92)
        actor.GetProperty().LightingOff()
        return actor

    def set_lights(self, renderer):
        sun = self.vtk.vtkLight()
        sun.SetPosition(*(self.centre + 5. * self.extent * np.array([0.4, -0.5, 1.])))
        sun.SetFocalPoint(*self.centre)
        sun.SetIntensity(0.75)
        renderer.AddLight(sun)
        lamp = self.vtk.vtkLight()
        lamp.SetLightTypeToHeadlight()
        lamp.SetIntensity(0.35)
        renderer.AddLight(lamp)

    def set_camera(self, renderer):
        camera = renderer.GetActiveCamera()
        camera.SetFocalPoint(*self.centre)
        depth = 0.5 * self.extent
        camera.SetPosition(*(self.centre + (self.half_height / np.tan(np.radians(0.5 * VIEW_ANGLE)) + depth) * self.direction))
        camera.SetViewUp(0., 0., 1.)
        camera.SetViewAngle(VIEW_ANGLE)
        renderer.ResetCameraClippingRange()

    def label(self, text, position):
        actor = self.vtk.vtkTextActor()
        actor.SetInput(text)
        actor.SetPosition(*position)
        actor.GetTextProperty().SetFontSize(20)
        actor.GetTextProperty().SetColor(0.1, 0.1, 0.1)
        return actor

    def colour_bar(self):
        bar = self.vtk.vtkScalarBarActor()
        bar.SetLookupTable(self.colours)
        bar.SetTitle("speed, m/s")
        bar.SetNumberOfLabels(3)
        bar.SetLabelFormat("%.2g")
        bar.UnconstrainedFontSizeOn()
        bar.SetVerticalTitleSeparation(10)
        bar.SetPosition(0.8, 0.5)
        bar.SetWidth(0.12)
        bar.SetHeight(0.45)
        for properties in (bar.GetLabelTextProperty(), bar.GetTitleTextProperty()):
            properties.SetColor(0.1, 0.1, 0.1)
            properties.SetFontSize(14)
            properties.BoldOff()
            properties.ShadowOff()
            properties.ItalicOff()
        return bar


def write_picture(vtk, window, path):
    window.Render()
    picture = vtk.vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(picture.GetOutputPort())
    writer.Write()
    print(f"Wrote {path}")


def main():
    arguments = parse_arguments()
    if arguments.columns is not None and arguments.columns < 1:
        raise OutputError("--columns must be 1 or more")
    vtk = load_vtk()
    snapshots = read_pvd(arguments.output / "solution.pvd")
    last = len(snapshots) - 1
    chosen = (nearest_snapshots(snapshots, arguments.times) if arguments.times
              else [snapshots[i] for i in sorted({0, last // 4, last})])
    cut = parse_cut(arguments.cut, direction_of_view(arguments))
    surfaces = [read_surface(vtk, path, cut) for _, path in chosen]
    if not any(surface.GetNumberOfPoints() for surface in surfaces):
        raise OutputError(f"{arguments.output}: no fluid behind {arguments.cut}" if cut else f"{arguments.output}: no fluid")
    solids = {time: read_surface(vtk, path, cut, 20.) for time, path in read_pvd(arguments.output / "solution.pvd", 1)
              if time in [time for time, _ in chosen]}
    scene = Scene(vtk, surfaces + list(solids.values()), arguments)
    # Walls that move have a file for each snapshot.
    moving = dict(read_pvd(arguments.output / "solution.pvd", 2))
    walls = {time: read_walls(vtk, moving.get(time, arguments.output / "walls.vtu"), scene) for time, _ in chosen}

    n_columns = arguments.columns or len(chosen)
    n_rows = -(-len(chosen) // n_columns)
    width, height = arguments.width, int(HEIGHT * arguments.width)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    # Several samples a pixel and transparent walls do not go together without a graphics card: parts of walls are missing.
    window.SetMultiSamples(0)
    window.SetSize(width * n_columns, height * n_rows)
    for i, ((time, _), surface) in enumerate(zip(chosen, surfaces)):
        column, row = i % n_columns, n_rows - 1 - i // n_columns
        renderer = vtk.vtkRenderer()
        renderer.SetBackground(1., 1., 1.)
        renderer.UseFXAAOn()
        renderer.SetViewport(column / n_columns, row / n_rows, (column + 1) / n_columns, (row + 1) / n_rows)
        renderer.AddActor(scene.fluid(surface))
        if time in solids:
            renderer.AddActor(scene.solid(solids[time]))
        renderer.AddActor(scene.floor_plane())
        if walls[time] is not None:
            renderer.AddActor(scene.walls(walls[time]))
        renderer.AddActor2D(scene.label(f"t = {time:g} s", (12, height - 32)))
        if i == len(chosen) - 1:
            renderer.AddActor2D(scene.colour_bar())
        scene.set_lights(renderer)
        scene.set_camera(renderer)
        window.AddRenderer(renderer)
    write_picture(vtk, window, arguments.to)


if __name__ == "__main__":
    run_script(main)
