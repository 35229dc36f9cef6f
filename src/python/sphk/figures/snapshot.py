# SPDX-License-Identifier: BSD-3-Clause
"""What the figures need of a snapshot: positions, any field by name, and the scene's own coordinate."""

import numpy as np


class Snapshot:
    """Gas of one file. `item` is the work order of the command line: time, dimension, the scene's coordinate and its
    range, units, the part of a vector that a name stands for, ...; `numbers` are arrays by name, or files with them."""

    def __init__(self, item):
        self.item = item

    def value(self, name):
        """A field by its name: a number a particle."""
        numbers = self.item["numbers"][name]
        return np.load(numbers) if isinstance(numbers, str) else np.asarray(numbers)

    def has(self, name):
        return name in self.item["numbers"]

    @property
    def x(self):
        return self.value("x")

    def abscissa(self):
        """x, y, the distance from the centre's z axis (R) or from the centre (r) of every particle."""
        return self.value("abscissa")
