# SPDX-License-Identifier: BSD-3-Clause
"""Arrangements of particles: places, and where masses are equal, the mass of each. Boxes are as in Particles."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _sphk
from .boxes import corner_and_sides


def lattice(n: int | Sequence[int], box: ArrayLike) -> NDArray:
    """(N, D) places on a square grid: n a side, or as many along each axis."""
    return arranged(n, box, "cubic")


def glass(n: int | Sequence[int], box: ArrayLike) -> NDArray:
    """(N, D) places of even density without preferred directions: copies of a glass, which is relaxed once and kept."""
    return arranged(n, box, "glass")


def arranged(n: int | Sequence[int], box: ArrayLike, arrangement: str, seed: int = 1) -> NDArray:
    """(N, D) places: "cubic", "glass" or "random", of which `seed` gives others."""
    lower, sides = corner_and_sides(box)
    counts = np.broadcast_to(n, len(sides)).astype(int).tolist()
    if min(counts) < 1:
        raise _sphk.InputError(f"n = {n}: one particle or more along each axis is wanted")
    return _sphk.arranged(counts, lower, sides, arrangement, seed)


def stretched(places: ArrayLike, density: Callable, box: ArrayLike, axis: int = 0) -> tuple[NDArray, float]:
    """Places of even density moved along an axis, so that their density follows `density(x)`, a function of arrays (N,)
    of that coordinate. Returns the places (N, D) and the mass of each, for a density in the box."""
    lower, sides = corner_and_sides(box)
    profile = _sphk.MassProfile(density(_midpoints(lower[axis], sides[axis])), lower[axis], sides[axis])
    moved = np.array(places, float)
    moved[:, axis] = profile.places((moved[:, axis] - lower[axis]) / sides[axis])
    across = np.prod(sides) / sides[axis]
    return moved, profile.mass * across / len(moved)


def shells(density: Callable, n: int, radius: float, dimension: int = 3,
           arrangement: str = "glass") -> tuple[NDArray, float]:
    """A ball (a disc in 2D) around the origin of equal masses, whose density follows `density(r)`, a function of arrays
    (N,): about n particles along its diameter. Returns the places (N, D) and the mass of each."""
    cube = arranged(n, ([-1.0] * dimension, [1.0] * dimension), arrangement)
    r = np.sqrt((cube**2).sum(1))
    inside = (r < 1) & (r > 0)
    places, r = cube[inside], r[inside]
    sphere = {1: 2.0, 2: 2 * np.pi, 3: 4 * np.pi}[dimension]
    middle = _midpoints(0, radius)
    profile = _sphk.MassProfile(density(middle) * sphere * middle**(dimension - 1), 0, radius)
    return places * (profile.places(r**dimension) / r)[:, None], profile.mass / len(places)


def from_density(density: Callable, n: int | Sequence[int], box: ArrayLike, arrangement: str = "glass",
                 cells: int | None = None) -> tuple[NDArray, float]:
    """Particles of equal masses whose density follows `density(x)`, a function of places (N, D) that gives (N,): about
    n along each side. An even arrangement is moved axis by axis, each by the share of mass below it where the axes
    before have put it (Rosenblatt's transformation), so that no particle is thrown away. The density is even in
    each of `cells` a side (256 in 2D, 48 in 3D). Returns the places (N, D) and the mass of each."""
    lower, sides = (np.array(numbers) for numbers in corner_and_sides(box))
    D = len(sides)
    cells = cells or {1: 16384, 2: 256, 3: 48}[D]
    middle = [_midpoints(lower[d], sides[d], cells) for d in range(D)]
    grid = np.stack([axis.ravel() for axis in np.meshgrid(*middle, indexing="ij")], 1)
    rho = np.asarray(density(grid), float).reshape([cells] * D)
    if not (np.isfinite(rho).all() and (rho >= 0).all() and rho.any()):
        raise _sphk.InputError("density: numbers of zero or more are wanted everywhere in the box, and not zero alone")
    share = (arranged(n, (np.zeros(D), np.ones(D)), arrangement)).copy()
    places = np.empty_like(share)
    before = np.zeros(len(share), int)  # the cell along the axes until now, as one number
    for axis in range(D):
        table = rho.reshape(cells**axis, cells, -1).sum(2)
        inner = _within(table, before, share[:, axis])
        places[:, axis] = lower[axis] + sides[axis] * inner / cells
        before = before * cells + np.minimum(inner.astype(int), cells - 1)
    return places, rho.mean() * sides.prod() / len(places)


def _within(table, row, share):
    """Where along each particle's row of a table that share of the row's sum lies, in cells."""
    inner = np.empty(len(share))
    order = np.argsort(row, kind="stable")
    for group in np.split(order, np.flatnonzero(np.diff(row[order])) + 1):
        below = np.concatenate([[0], np.cumsum(table[row[group[0]]])])
        inner[group] = np.interp(share[group] * below[-1], below, np.arange(len(below)))
    return inner


def _midpoints(lower, side, cells=16384):
    return lower + side * (np.arange(cells) + 0.5) / cells
