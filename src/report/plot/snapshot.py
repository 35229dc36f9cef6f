"""What the figures need of a snapshot: positions, the gas fields, and coordinates along the scene's abscissa."""

import h5py
import numpy as np

DATASETS = {"rho": "Densities", "P": "Pressures", "u": "InternalEnergies", "A": "Entropies", "m": "Masses"}


class Snapshot:
    """Gas of one file. `item` is the work order of the command line: dimension, box, abscissa, centre and
    its velocity, ..."""

    def __init__(self, item):
        self.item = item
        with h5py.File(item["file"], "r") as file:
            gas = file["PartType0"]
            points = file["VTKHDF/Points"] if "VTKHDF/Points" in file else gas["Coordinates"]  # not moved for readers
            self.x = points[...].astype(float)
            self.x[:, item["dimension"]:] = 0
            self.velocity = gas["Velocities"][...].astype(float) - np.array(item["velocity"])
            self.E0 = gas["E0"][...].astype(float) if "E0" in gas else None
            self.nearest = gas["NearestNeighbour"][...].astype(float) if "NearestNeighbour" in gas else None
            self.fields = {name: gas[key][...] for name, key in DATASETS.items() if key in gas}

    def offset(self):
        """Vectors from the centre, by the nearest image along periodic axes."""
        d = self.x - np.array(self.item["centre"])
        for axis in range(self.item["dimension"]):
            if self.item["periodic"][axis]:
                size = self.item["box_size"][axis]
                d[:, axis] -= size * np.round(d[:, axis] / size)
        return d

    def abscissa(self):
        """x, y, the distance from the centre's z axis (R) or from the centre (r) of every particle."""
        if self.item["abscissa"] in ("x", "y"):
            return self.x[:, "xy".index(self.item["abscissa"])]
        d = self.offset()
        return np.sqrt((d[:, :2] ** 2).sum(1) if self.item["abscissa"] == "R" else (d**2).sum(1))

    def value(self, name):
        """A field by its short name; v is v_x along x and y, azimuthal along R and radial along r."""
        if name in self.fields:
            return self.fields[name]
        if self.item["abscissa"] in ("x", "y"):
            return self.velocity[:, 0]
        d, v = self.offset(), self.velocity
        if self.item["abscissa"] == "R":
            return (d[:, 0] * v[:, 1] - d[:, 1] * v[:, 0]) / np.maximum(np.hypot(d[:, 0], d[:, 1]), 1e-300)
        return (d * v).sum(1) / np.maximum(self.abscissa(), 1e-300)

    def can_show(self, name):
        return name in self.fields or name == "v"
