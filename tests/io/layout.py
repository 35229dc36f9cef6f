# SPDX-License-Identifier: BSD-3-Clause
"""Looks at snapshots with h5py: every attribute's name, type and shape that readers of SWIFT files rely on, the hard
links, and initial conditions of kinds that only other writers make. Usage: layout.py IO_EXAMPLE"""

import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import h5py
    import numpy as np
except ImportError:
    print("skipped: h5py is missing (apt install python3-h5py)")
    sys.exit(77)

STRING = "S"
ATTRIBUTES = {  # group: {attribute: (type, shape)}; () is a scalar, as SWIFT has its strings
    "Header": {
        **dict.fromkeys(["Code", "Generator", "RunName", "SnapshotDate", "OutputType", "SelectOutput"], (STRING, ())),
        **dict.fromkeys(["BoxSize", "Shift"], ("f8", (3,))),
        **dict.fromkeys(["Time", "Redshift", "Scale-factor"], ("f8", (1,))),
        **dict.fromkeys(["Dimension", "Virtual", "ThisFile", "NumFilesPerSnapshot"], ("i4", (1,))),
        **dict.fromkeys(["NumPart_ThisFile", "TotalNumberOfParticles"], ("i8", (6,))),
        **dict.fromkeys(["NumPart_Total", "NumPart_Total_HighWord", "Flag_Entropy_ICs"], ("u4", (6,))),
        **dict.fromkeys(["MassTable", "InitialMassTable"], ("f8", (6,))),
        "CanHaveTypes": ("i4", (6,)),
    },
    "Policy": {"cosmological integration": ("i4", (1,))},
    "RuntimePars": {"PeriodicBoundariesOn": ("i4", (1,))},
    "Cosmology": {"Cosmological run": ("i4", (1,))},
    "SubgridScheme": {},
    "Parameters": dict.fromkeys(["InitialConditions:periodic", "sph:kernel", "time:courant"], (STRING, ())),
    "HydroScheme": {
        **dict.fromkeys(["Scheme", "Kernel function"], (STRING, ())),
        **dict.fromkeys(["Adiabatic index", "Kernel eta", "Kernel gamma", "Kernel target N_ngb", "CFL parameter"],
                        ("f8", (1,))),
        "Dimension": ("i4", (1,)),
    },
    "Code": dict.fromkeys(["Code", "Code Version", "Git Revision", "Compiler Name", "Compiler Version",
                           "HDF5 library version", "Kokkos backend"], (STRING, ())),
    "Cells/Meta-data": {"dimension": ("i4", (3,)), "nr_cells": ("i4", (1,)), "size": ("f8", (3,))},
    "VTKHDF": {"Version": ("i8", (2,)), "Type": (STRING, ())},
    "sphk": {
        **dict.fromkeys(["Scene", "Scheme", "Kernel", "Precision", "SceneText"], (STRING, ())),
        **dict.fromkeys(["SchemaVersion", "Dimension", "CodeUnits"], ("i4", (1,))),
        **dict.fromkeys(["BoxLower", "BoxSize"], ("f8", (3,))),
        "Neighbours": ("f8", (1,)), "Step": ("i8", (1,)), "Periodic": ("i4", (3,)),
    },
}
for group in ["Units", "InternalCodeUnits"]:
    ATTRIBUTES[group] = {f"Unit {unit} in cgs (U_{symbol})": ("f8", (1,)) for unit, symbol in
                         [("mass", "M"), ("length", "L"), ("time", "t"), ("current", "I"), ("temperature", "T")]}
FIELD_ATTRIBUTES = {
    **{f"U_{symbol} exponent": ("f4", (1,)) for symbol in "MLtIT"},
    **dict.fromkeys(["a-scale exponent", "h-scale exponent"], ("f4", (1,))),
    **dict.fromkeys(["Description", "Expression for physical CGS units", "Lossy compression filter"], (STRING, ())),
    "Conversion factor to CGS (not including cosmological corrections)": ("f8", (1,)),
    **dict.fromkeys(["Value stored as physical", "Property can be converted to comoving"], ("i4", (1,))),
}
N = 50
DATASETS = {
    **{name: ("f8", (N, 3)) for name in ["PartType0/Coordinates", "PartType0/Velocities", "VTKHDF/Points"]},
    **{f"PartType0/{name}": ("f8", (N,)) for name in ["Masses", "Densities", "InternalEnergies", "Pressures",
                                                      "SmoothingLengths", "SmoothingLength", "Entropies"]},
    "PartType0/ParticleIDs": ("u8", (N,)),
    "Cells/Centres": ("f8", (1, 3)),
    **{f"Cells/{name}/PartType0": ("i8", (1,)) for name in ["Counts", "OffsetsInFile", "Files"]},
    **{f"Cells/{name}/PartType0": ("f8", (1, 3)) for name in ["MinPositions", "MaxPositions"]},
    **{f"VTKHDF/{name}": ("i8", (1,)) for name in ["NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"]},
    "VTKHDF/Connectivity": ("i8", (N,)), "VTKHDF/Offsets": ("i8", (N + 1,)), "VTKHDF/Types": ("u1", (N,)),
}
HARD_LINKS = {"PartType0/Density": "PartType0/Densities", "PartType0/InternalEnergy": "PartType0/InternalEnergies",
              "PartType0/Pressure": "PartType0/Pressures", "VTKHDF/PointData/Densities": "PartType0/Densities",
              "VTKHDF/PointData/ParticleIDs": "PartType0/ParticleIDs"}
FOREIGN_GROUPS = ["Config", "Constants", "HashTable", "FOF", "Group", "Subhalo"]  # yt would see another code's file


def same_type(found, wanted):
    return found.kind == STRING if wanted == STRING else found == np.dtype(wanted)


def check_attributes(holder, wanted):
    for name, (kind, shape) in wanted.items():
        assert name in holder.attrs, f"{holder.name}@{name} is missing"
        attribute = holder.attrs.get_id(name)
        assert same_type(attribute.dtype, kind), f"{holder.name}@{name} is {attribute.dtype}, wanted {kind}"
        assert attribute.shape == shape, f"{holder.name}@{name} has shape {attribute.shape}, wanted {shape}"


def check_values(file, dimension):
    header = file["Header"].attrs
    assert header["Code"] == b"SWIFT" and header["Dimension"][0] == 3
    assert file["HydroScheme"].attrs["Dimension"][0] == file["sphk"].attrs["Dimension"][0] == dimension
    assert list(header["NumPart_ThisFile"]) == list(header["NumPart_Total"]) == [N, 0, 0, 0, 0, 0]
    assert file["Parameters"].attrs["InitialConditions:periodic"] == b"1"
    assert file["VTKHDF"].attrs["Type"] == b"UnstructuredGrid"
    positions = file["PartType0/Coordinates"][:]
    assert np.all(positions >= 0) and np.all(positions < header["BoxSize"])
    assert np.all(positions[:, dimension:] == header["BoxSize"][dimension:] / 2)
    assert np.all(file["Cells/MinPositions/PartType0"][0] == positions.min(axis=0))
    assert np.all(file["Cells/MaxPositions/PartType0"][0] == positions.max(axis=0))
    assert file["Cells/Counts/PartType0"][0] == N
    density = file["PartType0/Densities"].attrs
    assert density["U_L exponent"][0] == -dimension and density["U_M exponent"][0] == 1


def check_snapshot(example, folder, dimension):
    path = folder / f"snap_{dimension}.hdf5"
    subprocess.run([example, "write", path, str(dimension)], check=True)
    with h5py.File(path, "r") as file:
        for group, wanted in ATTRIBUTES.items():
            check_attributes(file[group], wanted)
        for name, (kind, shape) in DATASETS.items():
            assert file[name].dtype == np.dtype(kind) and file[name].shape == shape, f"{name}: {file[name]}"
        for dataset in file["PartType0"].values():
            check_attributes(dataset, FIELD_ATTRIBUTES)
        for link, target in HARD_LINKS.items():
            assert file[link] == file[target], f"{link} is no hard link to {target}"
        for group in FOREIGN_GROUPS:
            assert group not in file, f"the group {group} must not be there"
        check_values(file, dimension)


def check_initial_condition(example, folder, libver):
    """Scalar attributes, big-endian reals, chunks with filters, a variable-length string, HDF5's newest layout."""
    path = folder / f"ic_{libver}.hdf5"
    n = 7
    x = np.arange(3 * n).reshape(n, 3) / 32
    v = -x
    m = np.arange(1, n + 1) / 4
    u = np.arange(1, n + 1) / 8
    ids = np.arange(n, 0, -1)
    with h5py.File(path, "w", libver=libver) as file:
        header = file.create_group("Header").attrs
        header["BoxSize"], header["Time"], header["Dimension"], header["NumFilesPerSnapshot"] = 1.0, 0.25, 3, 1
        header["Code"] = "somebody's"
        header["NumPart_ThisFile"] = [n, 0, 0, 0, 0, 0, 0]
        gas = file.create_group("PartType0")
        gas.create_dataset("Coordinates", data=x.astype(">f4"), chunks=(3, 3), compression="gzip", shuffle=True)
        gas.create_dataset("Velocities", data=v.astype(">f8"), chunks=(2, 2), fletcher32=True)
        gas.create_dataset("Masses", data=m.astype("f4"), maxshape=(None,))
        gas.create_dataset("InternalEnergy", data=u.reshape(n, 1))
        gas.create_dataset("ParticleIDs", data=ids.astype("i2"))
    rows = subprocess.run([example, "read", path], check=True, capture_output=True, text=True).stdout
    read = np.array([[float(word) for word in row.split()] for row in rows.splitlines()])
    assert np.array_equal(read, np.column_stack([x, v, m, u, ids])), f"{libver}: read {read}"


def main():
    example = Path(sys.argv[1])
    with tempfile.TemporaryDirectory() as name:
        for dimension in [1, 2, 3]:
            check_snapshot(example, Path(name), dimension)
        for libver in ["earliest", "latest"]:
            check_initial_condition(example, Path(name), libver)


main()
