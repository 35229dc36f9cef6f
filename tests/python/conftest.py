# SPDX-License-Identifier: BSD-3-Clause
"""Gas that the tests share."""

import numpy as np
import pytest

import sphk


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """An empty folder, in which the test is."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def even_gas(n=16, u=1.0, velocity=None, dimension=2, **more):
    """n^D particles of density 1 on a lattice in a periodic box of side 1."""
    x = sphk.ic.lattice(n, (1,) * dimension)
    return sphk.Particles(position=x, mass=1 / len(x), u=u, velocity=velocity, box=(1,) * dimension, periodic=True,
                          **more)


def sheared_gas(n=16, **more):
    """The same with a smooth motion, so that something happens."""
    x = sphk.ic.lattice(n, (1, 1))
    v = 0.3 * np.stack([np.sin(2 * np.pi * x[:, 1]), np.cos(2 * np.pi * x[:, 0])], 1)
    return sphk.Particles(position=x, mass=1 / len(x), u=1.0, velocity=v, box=(1, 1), periodic=True, **more)


SETTINGS = {"scheme": "sph", "gamma": 5 / 3}
