# SPDX-License-Identifier: BSD-3-Clause
"""Gas of an initial condition, as arrays."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from . import _sphk
from .boxes import corner_and_sides


class Particles:
    """Gas: N particles in D = 1, 2 or 3 dimensions, in any one system of units.

    position  (N, D), or (N,) in 1D: lengths
    mass      (N,) or one number for all: masses
    u         (N,) or one number: thermal energies a mass
    velocity  (N, D) or (D,), at rest where left out: lengths a time
    box       D lengths of the sides, from the origin on; or (lower, upper), two corners of D numbers each
    periodic  True, False, or one of them for each axis
    id        (N,) unique whole numbers; 1 to N where left out
    h         (N,) support radii, for the reader: a simulation finds its own
    alpha     (N,) of the dissipation switch at the start, for schemes that have one; 0 where left out
    time      of the start

    InputError where an array has another shape."""

    def __init__(self, *, position: ArrayLike, mass: ArrayLike, u: ArrayLike, box: ArrayLike,
                 velocity: ArrayLike | None = None, periodic: bool | Sequence[bool] = False,
                 id: ArrayLike | None = None, h: ArrayLike | None = None, alpha: ArrayLike | None = None,
                 time: float = 0.0):
        self.position = _rows("position", position)
        n, self.dimension = self.position.shape
        if self.dimension not in (1, 2, 3):
            raise _sphk.InputError(f"position: its shape is {self.position.shape}; (N, D) with D = 1, 2 or 3 is wanted")
        self.velocity = np.zeros((n, self.dimension)) if velocity is None else self._vectors("velocity", velocity)
        self.mass = self._numbers("mass", mass)
        self.u = self._numbers("u", u)
        self.h = None if h is None else self._numbers("h", h)
        self.alpha = None if alpha is None else self._numbers("alpha", alpha)
        self.id = None if id is None else self._ids(id)
        self.lower, self.sides = corner_and_sides(box, self.dimension)
        self.periodic = self._axes(periodic)
        self.time = float(time)

    def __len__(self) -> int:
        return len(self.position)

    def __repr__(self):
        return f"<sphk.Particles: {len(self)} in {self.dimension}D>"

    def _vectors(self, name, values):
        array = _floats(name, values)
        if array.ndim == 1 and self.dimension == 1 and len(array) == len(self):
            array = array[:, None]
        if array.shape not in [(len(self), self.dimension), (self.dimension,)]:
            raise _sphk.InputError(f"{name}: its shape is {array.shape}; {(len(self), self.dimension)}, as of "
                                   f"position, or {(self.dimension,)} for all is wanted")
        return np.ascontiguousarray(np.broadcast_to(array, (len(self), self.dimension)))

    def _numbers(self, name, values):
        array = _floats(name, values)
        if array.shape not in [(len(self),), ()]:
            raise _sphk.InputError(f"{name}: its shape is {array.shape}; {(len(self),)}, a number for each row of "
                                   "position, or one for all is wanted")
        return np.ascontiguousarray(np.broadcast_to(array, len(self)))

    def _ids(self, values):
        array = np.asarray(values)
        if array.shape != (len(self),) or array.dtype.kind not in "iu" or (array.size and array.min() < 0):
            raise _sphk.InputError(f"id: {array.dtype} of shape {array.shape}; {(len(self),)} whole numbers from 0 on "
                                   "are wanted")
        return np.ascontiguousarray(array, np.uint64)

    def _axes(self, periodic):
        array = np.asarray(periodic, bool)
        if array.shape not in [(), (self.dimension,)]:
            raise _sphk.InputError(f"periodic: its shape is {array.shape}; True, False or {self.dimension} of them are "
                                   "wanted")
        return np.broadcast_to(array, self.dimension).tolist()

    def _gas(self):
        return _sphk.gas(self.position, self.velocity, self.mass, self.u, self.alpha, self.id, self.lower, self.sides,
                         self.periodic, self.time)


def _floats(name, values):
    try:
        return np.ascontiguousarray(values, float) if np.ndim(values) else np.asarray(values, float)
    except (TypeError, ValueError) as error:
        raise _sphk.InputError(f"{name}: numbers are wanted: {error}") from None


def _rows(name, values):
    array = _floats(name, values)
    array = array[:, None] if array.ndim == 1 else array
    if array.ndim != 2:
        raise _sphk.InputError(f"{name}: its shape is {array.shape}; (N, D) is wanted, a row for each particle")
    return array
