# SPDX-License-Identifier: GPL-3.0-or-later
"""Read snapshots with VTK (Debian: python3-vtk9)."""

import numpy as np

from lahar_output import OutputError


def load_vtk():
    try:
        import vtkmodules.all as vtk
    except ImportError as error:
        raise OutputError("VTK for Python is missing (Debian: apt install python3-vtk9)") from error
    return vtk


def read_joined(vtk, path):
    """The mesh of a snapshot. Every cell of the file has corners of its own; here cells share them."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
    if not path.is_file():
        raise OutputError(f"{path}: no such file")
    reader = vtk.vtkXMLPUnstructuredGridReader() if path.suffix == ".pvtu" else vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    apart = reader.GetOutput()
    points, first, number = np.unique(vtk_to_numpy(apart.GetPoints().GetData()), axis=0, return_index=True, return_inverse=True)

    joined = vtk.vtkUnstructuredGrid()
    joined_points = vtk.vtkPoints()
    joined_points.SetData(numpy_to_vtk(points, deep=True))
    joined.SetPoints(joined_points)
    cells = vtk.vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(vtk_to_numpy(apart.GetCells().GetOffsetsArray()).astype(np.int64), deep=True),
                  numpy_to_vtkIdTypeArray(number[vtk_to_numpy(apart.GetCells().GetConnectivityArray())].astype(np.int64), deep=True))
    joined.SetCells(apart.GetCellTypesArray(), cells)
    joined.GetCellData().ShallowCopy(apart.GetCellData())
    for i in range(apart.GetPointData().GetNumberOfArrays()):
        array = apart.GetPointData().GetArray(i)
        copy = numpy_to_vtk(vtk_to_numpy(array)[first], deep=True)
        copy.SetName(array.GetName())
        joined.GetPointData().AddArray(copy)
    return joined
