#!/usr/bin/python3
"""Views of runs in space: the fluid's free surface coloured by speed, at several times side by side.

    contrib/plot/render.py output-mini-cone --times 0 0.1 5 --to cone.png

Needs VTK (Debian: python3-vtk9) and, where there is no display, a virtual one (xvfb-run).
"""

import argparse
import pathlib

import numpy as np

from lahar_output import nearest_snapshots, read_pvd, run_script
from vtk_output import load_vtk, read_joined


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", type=pathlib.Path, help="output directory of a run in space")
    parser.add_argument("--times", type=float, nargs="+", help="times in s (default: the first, a middle and the last)")
    parser.add_argument("--to", type=pathlib.Path, default=pathlib.Path("views.png"), help="the picture (default: views.png)")
    parser.add_argument("--fastest", type=float, help="speed at the end of the colour scale, m/s (default: the largest)")
    parser.add_argument("--azimuth", type=float, default=30., help="of the camera about the vertical, degrees")
    parser.add_argument("--elevation", type=float, default=25., help="of the camera above the floor, degrees")
    parser.add_argument("--width", type=int, default=520, help="of one view, pixels")
    return parser.parse_args()


def read_surface(vtk, path):
    """The outside of a snapshot as smooth triangles with the field 'speed' at its points."""
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(read_joined(vtk, path))
    norm = vtk.vtkArrayCalculator()
    norm.SetInputConnection(surface.GetOutputPort())
    norm.AddVectorArrayName("velocity")
    norm.SetFunction("mag(velocity)")
    norm.SetResultArrayName("speed")
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputConnection(norm.GetOutputPort())
    normals.SetFeatureAngle(50.)
    normals.Update()
    return normals.GetOutput()


def main():
    arguments = parse_arguments()
    vtk = load_vtk()
    snapshots = read_pvd(arguments.output / "solution.pvd")
    last = len(snapshots) - 1
    chosen = (nearest_snapshots(snapshots, arguments.times) if arguments.times
              else [snapshots[i] for i in sorted({0, last // 4, last})])
    surfaces = [read_surface(vtk, path) for _, path in chosen]
    fastest = arguments.fastest or max(surface.GetPointData().GetArray("speed").GetRange()[1] for surface in surfaces)

    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(arguments.width * len(chosen), int(0.8 * arguments.width))
    colours = vtk.vtkLookupTable()
    colours.SetHueRange(0.62, 0.02)
    colours.SetSaturationRange(0.55, 0.85)
    colours.SetRange(0., fastest)
    colours.Build()
    bounds = np.array([surface.GetBounds() for surface in surfaces])
    centre = 0.5 * (bounds[:, 0::2].min(axis=0) + bounds[:, 1::2].max(axis=0))
    extent = (bounds[:, 1::2].max(axis=0) - bounds[:, 0::2].min(axis=0)).max()
    azimuth, elevation = np.radians([arguments.azimuth, arguments.elevation])
    direction = np.array([np.cos(elevation) * np.sin(azimuth), -np.cos(elevation) * np.cos(azimuth), np.sin(elevation)])
    for i, ((time, _), surface) in enumerate(zip(chosen, surfaces)):
        renderer = vtk.vtkRenderer()
        renderer.SetBackground(1., 1., 1.)
        renderer.SetViewport(i / len(chosen), 0., (i + 1) / len(chosen), 1.)
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputData(surface)
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray("speed")
        mapper.SetLookupTable(colours)
        mapper.SetScalarRange(0., fastest)
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetSpecular(0.15)
        renderer.AddActor(actor)
        floor = vtk.vtkPlaneSource()
        z = bounds[:, 4].min() - 1e-3 * extent
        half = 0.65 * extent
        floor.SetOrigin(centre[0] - half, centre[1] - half, z)
        floor.SetPoint1(centre[0] + half, centre[1] - half, z)
        floor.SetPoint2(centre[0] - half, centre[1] + half, z)
        floor_mapper = vtk.vtkPolyDataMapper()
        floor_mapper.SetInputConnection(floor.GetOutputPort())
        floor_actor = vtk.vtkActor()
        floor_actor.SetMapper(floor_mapper)
        floor_actor.GetProperty().SetColor(0.92, 0.92, 0.92)
        floor_actor.GetProperty().LightingOff()
        renderer.AddActor(floor_actor)
        text = vtk.vtkTextActor()
        text.SetInput(f"t = {time:g} s")
        text.SetPosition(12, int(0.8 * arguments.width) - 32)
        text.GetTextProperty().SetFontSize(20)
        text.GetTextProperty().SetColor(0.1, 0.1, 0.1)
        renderer.AddActor2D(text)
        if i == len(chosen) - 1:
            bar = vtk.vtkScalarBarActor()
            bar.SetLookupTable(colours)
            bar.SetTitle("speed, m/s")
            bar.SetNumberOfLabels(3)
            bar.SetLabelFormat("%.2g")
            bar.UnconstrainedFontSizeOn()
            bar.SetPosition(0.8, 0.5)
            bar.SetWidth(0.12)
            bar.SetHeight(0.45)
            for properties in (bar.GetLabelTextProperty(), bar.GetTitleTextProperty()):
                properties.SetColor(0.1, 0.1, 0.1)
                properties.SetFontSize(14)
                properties.BoldOff()
                properties.ShadowOff()
                properties.ItalicOff()
            renderer.AddActor2D(bar)
        sun = vtk.vtkLight()
        sun.SetPosition(*(centre + 5. * extent * np.array([0.4, -0.5, 1.])))
        sun.SetFocalPoint(*centre)
        sun.SetIntensity(0.75)
        renderer.AddLight(sun)
        lamp = vtk.vtkLight()
        lamp.SetLightTypeToHeadlight()
        lamp.SetIntensity(0.35)
        renderer.AddLight(lamp)
        camera = renderer.GetActiveCamera()
        camera.SetFocalPoint(*centre)
        camera.SetPosition(*(centre + 2.6 * extent * direction))
        camera.SetViewUp(0., 0., 1.)
        camera.SetViewAngle(21.)
        renderer.ResetCameraClippingRange()
        window.AddRenderer(renderer)
    window.Render()
    picture = vtk.vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(str(arguments.to))
    writer.SetInputConnection(picture.GetOutputPort())
    writer.Write()
    print(f"Wrote {arguments.to}")


if __name__ == "__main__":
    run_script(main)
