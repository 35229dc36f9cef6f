# SPDX-License-Identifier: BSD-3-Clause
"""VTK's reader of /VTKHDF, which ParaView uses for the files that run.hdf.series names."""

import json

import numpy as np
from runs import T_END, near
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOHDF import vtkHDFReader


def read(path):
    reader = vtkHDFReader()
    assert reader.CanReadFile(path), f"{path} cannot be read"
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def check_vtk(truth):
    grid = read(truth.file)
    assert np.array_equal(vtk_to_numpy(grid.GetPoints().GetData()), truth.x), "points are the run's own"
    assert grid.GetNumberOfCells() == len(truth.x)
    values = grid.GetPointData()
    near(vtk_to_numpy(values.GetArray("Masses")).sum(), truth.mass, 1e-12, "mass")
    for name in ["Densities", "Pressures", "Velocities"]:
        assert np.array_equal(vtk_to_numpy(values.GetArray(name)), truth.fields[name]), name


def check_series(truth):
    series = json.loads((truth.folder / "run.hdf.series").read_text())
    assert series["file-series-version"] == "1.0"
    assert [entry["time"] for entry in series["files"]] == [0, T_END / 2, T_END]
    for entry in series["files"]:
        assert read(str(truth.folder / entry["name"])).GetNumberOfPoints() == len(truth.x)
