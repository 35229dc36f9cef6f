# SPDX-License-Identifier: BSD-3-Clause
"""The gas of a simulation, as arrays."""

from __future__ import annotations

from collections.abc import Mapping

from numpy.typing import NDArray

from . import _sphk


# What figures call them, too.
SHORT = {"rho": "Densities", "P": "Pressures", "u": "InternalEnergies", "A": "Entropies", "h": "SmoothingLength",
         "m": "Masses", "x": "Coordinates", "v": "Velocities"}


class Fields(Mapping):
    """The gas as it is now, by the names of snapshots: Coordinates and Velocities (N, D), Masses, Densities,
    InternalEnergies (a mass), Pressures, Entropies (P / rho^gamma), SmoothingLength (the support radius), each (N,),
    and what the scheme adds; in the units of the particles that came in.

    The first ones are also known as x, v, m, rho, u, P, A, h.

    Rows are in the run's own order, along its curve through space, which a step may change: `ids` says whose they are,
    and `fields.by_id(name)` sorts. An array is read-only, float64, and stays readable whatever the run does. It is a
    copy of now; of a simulation with units="given" it is the run's own memory, without a copy, as far as the engine
    holds the field and no particle is in the middle of a step of its own. Such a view follows the run: after a step it
    shows the later state, whose rows may be others'. Vectors are then the transpose of rows of components, as the
    engine has them, with strides that say so."""

    def __init__(self, run):
        self._run = run

    def __getitem__(self, name: str) -> NDArray:
        try:
            return self._run.field(SHORT.get(name, name))
        except _sphk.InputError as error:
            raise KeyError(str(error)) from None

    def __iter__(self):
        return iter(self._run.fields())

    def __len__(self):
        return len(self._run.fields())

    @property
    def ids(self) -> NDArray:
        """(N,) uint64: whose rows these are now."""
        return self._run.ids()

    def by_id(self, name: str) -> NDArray:
        """A copy of the field, sorted by id: in the order of the particles that came in, if they came without ids."""
        return self[name][self.ids.argsort()]
