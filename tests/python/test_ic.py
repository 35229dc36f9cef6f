# SPDX-License-Identifier: BSD-3-Clause
"""Arrangements of particles, against the densities that they are made from."""

import numpy as np
import pytest

import sphk


def test_lattices():
    x = sphk.ic.lattice((4, 2), ((-1, 0), (1, 1)))
    assert x.shape == (8, 2) and np.array_equal(np.unique(x[:, 0]), [-0.75, -0.25, 0.25, 0.75])
    assert sphk.ic.arranged(5, (1, 1, 1), "random", seed=3).shape == (125, 3)
    with pytest.raises(sphk.InputError, match="one particle"):
        sphk.ic.lattice(0, (1, 1))


def test_stretched_rows_have_equal_masses_between_them():
    """rho = 1 + x on [0, 2]: mass below x is x + x^2/2, 4 in all."""
    x, mass = sphk.ic.stretched(sphk.ic.lattice((40, 3), (2, 1)), lambda x: 1 + x, (2, 1))
    assert np.isclose(mass, 4 / 120)
    rows = np.unique(x[:, 0].round(12))
    assert np.allclose(rows + rows**2 / 2, 4 * (np.arange(40) + 0.5) / 40, atol=1e-6)


@pytest.mark.parametrize("dimension, n, whole", [(1, 200, 2.0), (2, 24, np.pi), (3, 24, 4 * np.pi / 3)])
def test_shells(dimension, n, whole):
    """rho = r^1/2 in a ball of radius 2: mass inside r as r^(D + 1/2)."""
    x, mass = sphk.ic.shells(lambda r: r**0.5, n, 2.0, dimension=dimension, arrangement="cubic")
    power = dimension + 0.5
    total = dimension * whole / power * 2**power
    assert np.isclose(mass * len(x), total, rtol=1e-3)
    r = np.sqrt((x**2).sum(1))
    assert r.max() <= 2
    for radius in (0.5, 1.0, 1.5):
        assert np.isclose(np.mean(r < radius), (radius / 2)**power, atol=0.03)


@pytest.mark.parametrize("dimension, n, cells", [(2, 64, None), (3, 24, 24)])
def test_from_density(dimension, n, cells):
    """A product of 1 + sin(2 pi x)/2 along each axis: quarters of the box hold (1/4 +- 1/(4 pi)) of the mass each."""
    def rho(x):
        return np.prod(1 + 0.5 * np.sin(2 * np.pi * x), axis=1)

    x, mass = sphk.ic.from_density(rho, n, (1,) * dimension, arrangement="cubic", cells=cells)
    assert np.isclose(mass * len(x), 1, rtol=1e-3) and x.min() >= 0 and x.max() <= 1
    for axis in range(dimension):
        assert np.isclose(np.mean(x[:, axis] < 0.5), 0.5 + 0.5 / np.pi, atol=2 / n)
    corner = np.all(x < 0.5, axis=1)
    assert np.isclose(np.mean(corner), (0.5 + 0.5 / np.pi)**dimension, atol=dimension * 2 / n)
