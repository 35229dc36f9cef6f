"""What the figures need of a snapshot: positions, any field by name, and coordinates along the scene's abscissa."""

import h5py
import numpy as np

AXES = "xyz"
MATRIX = ("xx", "yy", "zz", "xy", "xz", "yz")


class Snapshot:
    """Gas of one file. `item` is the work order of the command line: dimension, box, abscissa, centre and its velocity,
    the dataset and part that every name stands for, ..."""

    def __init__(self, item):
        self.item = item
        self.datasets = {}
        self.x = self.places()

    def dataset(self, name):
        if name not in self.datasets:
            with h5py.File(self.item["file"], "r") as file:
                self.datasets[name] = file["PartType0"][name][...].astype(float)
        return self.datasets[name]

    def places(self):
        """The particles' own places: where a file has moved them for readers, VTK's points are not."""
        with h5py.File(self.item["file"], "r") as file:
            points = file["VTKHDF/Points"] if "VTKHDF/Points" in file else file["PartType0/Coordinates"]
            x = points[...].astype(float)
        x[:, self.item["dimension"]:] = 0
        return x

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
        if self.item["abscissa"] in AXES:
            return self.x[:, AXES.index(self.item["abscissa"])]
        d = self.offset()
        return np.sqrt((d[:, :2] ** 2).sum(1) if self.item["abscissa"] == "R" else (d**2).sum(1))

    def about_centre(self, name, part):
        """A vector's component along R, phi or r; velocities are beside the centre's own."""
        vector, d = self.dataset(name), self.offset()
        if name == "Velocities":
            vector = vector - np.array(self.item["velocity"])
        if part == "r":
            return (d * vector).sum(1) / np.maximum(np.sqrt((d**2).sum(1)), 1e-300)
        R = np.maximum(np.hypot(d[:, 0], d[:, 1]), 1e-300)
        if part == "R":
            return (d[:, 0] * vector[:, 0] + d[:, 1] * vector[:, 1]) / R
        return (d[:, 0] * vector[:, 1] - d[:, 1] * vector[:, 0]) / R

    def value(self, name):
        """A field by its name: a number a particle."""
        dataset, part = self.item["names"][name]
        values = self.dataset(dataset)
        if part == "modulus":
            return np.sqrt((values**2).sum(1))
        if part in ("R", "phi", "r"):
            return self.about_centre(dataset, part)
        if part:
            return values[:, (MATRIX if len(part) == 2 else AXES).index(part)]
        return values.reshape(len(values))

    def has(self, name):
        return name in self.item["names"]
