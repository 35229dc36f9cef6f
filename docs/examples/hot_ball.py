# SPDX-License-Identifier: BSD-3-Clause
"""A ball of hot gas in a periodic box of cold gas, in 2D, as an HDF5 file in SWIFT's layout. Usage: hot_ball.py FILE"""

import sys

import h5py
import numpy as np

n, gamma, rho = 64, 5 / 3, 1.0
centres = (np.arange(n) + 0.5) / n
x, y = (axis.ravel() for axis in np.meshgrid(centres, centres))
pressure = np.where(np.hypot(x - 0.5, y - 0.5) < 0.2, 10.0, 1.0)

with h5py.File(sys.argv[1], "w") as file:
    file.create_group("Header").attrs.update(BoxSize=[1.0, 1.0, 1.0], Dimension=2, NumPart_Total=[n * n, 0, 0, 0, 0, 0])
    gas = file.create_group("PartType0")
    gas["Coordinates"] = np.column_stack([x, y, np.zeros(n * n)])
    gas["Velocities"] = np.zeros((n * n, 3))
    gas["Masses"] = np.full(n * n, rho / n**2)
    gas["InternalEnergies"] = pressure / ((gamma - 1) * rho)
