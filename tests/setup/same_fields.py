# SPDX-License-Identifier: BSD-3-Clause
"""same_fields.py TOLERANCE A.hdf5 B.hdf5 FIELD...: do these fields of two snapshots, or of two files of `sphk rates`,
agree? The largest difference counts, relative to the largest number of the field."""

import sys

import h5py
import numpy as np

tolerance = float(sys.argv[1])
files = [h5py.File(name)["PartType0"] for name in sys.argv[2:4]]
orders = [np.argsort(file["ParticleIDs"][:]) for file in files]
for name in sys.argv[4:]:
    a, b = (file[name][:][order] for file, order in zip(files, orders))
    error = np.abs(a - b).max() / np.abs(a).max()
    print(f"  {name} differs by {error:.1e} of its largest number, allowed are {tolerance:.0e}")
    if not error <= tolerance:
        sys.exit(1)
