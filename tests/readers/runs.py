# SPDX-License-Identifier: BSD-3-Clause
"""Small runs, and what is true of them: from what the scenes are, and from the points that ParaView is given."""

import subprocess
from dataclasses import dataclass

import h5py
import numpy as np

KPC, MSUN, KM_S = 3.0856775814913673e21, 1.98841e33, 1e5
T_END = 0.1
RUNS = {  # dimension, middle of the gas, mass (None: as the particles have it), arguments of sphk run
    "line": (1, 0.5, 1, "uniform -n 16 --set scene.dimension=1 --set scene.lattice=cubic"),
    "plane": (2, 0.5, 1, "uniform -n 16 --set scene.dimension=2 --set scene.lattice=cubic"),
    "ring": (2, 0, None, "ring -n 16 --scheme gadget2"),  # open
    "sedov": (3, 0, 1, "sedov -n 10 --set scene.lattice=cubic --scheme gadget2 --set scene.blast_radius=0.15"
                    " --set units.length=kpc --set units.mass='1e10 Msun' --set units.velocity=km/s"),
    "noh": (3, 0, None, "noh -n 6 --scheme gadget2"),  # open
}


def check_rates(truth):
    """The right-hand side of a snapshot stands at the run's own coordinates."""
    rates = truth.folder / "rates.hdf5"
    subprocess.run([truth.sphk, "rates", truth.file, "--out", rates], check=True, stdout=subprocess.DEVNULL)
    with h5py.File(rates) as file:
        x = file["PartType0/Coordinates"][...]
        assert np.array_equal(x[:, :truth.dimension], truth.x[:, :truth.dimension]), "places"
        assert (x[:, truth.dimension:] == 0).all(), "axes that the gas does not fill"


@dataclass
class Truth:
    sphk: str
    folder: object
    file: str
    dimension: int
    x: np.ndarray  # of the run; in the middle of the axes that the gas does not fill
    fields: dict
    mass: float
    units: tuple  # of length, mass, time in cgs

    def header(self, name):
        with h5py.File(self.file) as file:
            return file["Header"].attrs[name]


def make(sphk, folder, name):
    dimension, middle, mass, arguments = RUNS[name]
    out = folder / name
    command = f"'{sphk}' run {arguments} --t-end {T_END} --out '{out}' --set output.snapshots=2"
    subprocess.run(command, shell=True, check=True, stdout=subprocess.DEVNULL)
    file = str(out / "snap_0002.hdf5")
    with h5py.File(file) as made:
        fields = {key: values[...] for key, values in made["PartType0"].items()}
        points = made["VTKHDF/Points"][...]
    near(points[:, :dimension].mean(0), np.full(dimension, middle), 1e-6, "the middle of the gas")
    length, unit_mass, velocity = (KPC, 1e10 * MSUN, KM_S) if "kpc" in arguments else (1, 1, 1)
    total = fields["Masses"].sum() if mass is None else mass
    return Truth(sphk, out, file, dimension, points, fields, total, (length, unit_mass, length / velocity))


def near(found, wanted, tolerance, what):
    found, wanted = np.asarray(found, dtype=float), np.asarray(wanted, dtype=float)
    scale = np.abs(wanted).max() or 1
    assert found.shape == wanted.shape, f"{what}: shape {found.shape}, wanted {wanted.shape}"
    assert np.abs(found - wanted).max() <= tolerance * scale, f"{what}: {found}, wanted {wanted}"


def check_places(x, box, truth, tolerance=1e-12):
    """Every particle is within the readers' box, at its own place; a plane or line in the middle of the rest."""
    x, box = np.asarray(x, dtype=float), np.asarray(box, dtype=float)
    assert (x >= 0).all() and (x < box).all(), f"particles from {x.min(0)} to {x.max(0)} in a box of {box}"
    near(x[:, :truth.dimension], (truth.x + truth.header("Shift"))[:, :truth.dimension], tolerance, "places")
    for axis in range(truth.dimension, 3):
        near(x[:, axis], np.full(len(x), box[axis] / 2), tolerance, f"the middle of axis {axis}")
