# SPDX-License-Identifier: BSD-3-Clause
"""Test problems by name."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from os import PathLike
from typing import Any

from . import program
from .folder import Run
from .simulation import Simulation


class Scene:
    """A scene with its settings: run() as `sphk run` does, or simulation() to step through it."""

    def __init__(self, what, keys):
        self.what, self.keys = str(what), keys

    def __repr__(self):
        return f"<sphk.Scene: {' '.join([self.what, *(f'{name}={value}' for name, value in self.keys.items())])}>"

    def run(self, out: str | PathLike | None = None, *, overwrite: bool = False, threads: int | None = None,
            progress: bool = False) -> Run:
        """Runs to its end in a process of its own, into the folder `out`: a temporary one where it is left out, which
        goes with the Run that this returns."""
        temporary = None if out else tempfile.TemporaryDirectory(prefix="sphk-")
        folder = out or temporary.name
        program.run(self.what, self.keys, folder, overwrite=overwrite, threads=threads, progress=progress)
        return Run(folder, temporary)

    def simulation(self, *, threads: int | None = None, units: str = "own") -> Simulation:
        """A Simulation of its gas, at the start."""
        return Simulation._of_scene(self.what, self.keys, threads, units)


def scene(what: str | PathLike, *, n: int | None = None, end: float | None = None, scheme: str | None = None,
          kernel: str | None = None, neighbours: float | None = None, gamma: float | None = None,
          precision: str | None = None, courant: float | None = None, energy: str | None = None,
          steps: str | None = None, settings: Mapping[str, Any] | None = None) -> Scene:
    """A test problem (`sphk list` shows them), a scene file (*.toml) or an initial condition (*.hdf5).

    n    particles along the box, or a unit of length
    end  time at which a run ends
    and as in Simulation. What is left out is the scene's own choice."""
    given = {"scene.n": n, "time.end": None if end is None else float(end), "sph.scheme": scheme, "sph.kernel": kernel,
             "sph.neighbours": neighbours, "sph.gamma": gamma, "sph.precision": precision, "time.courant": courant,
             "sph.energy": energy, "time.steps": steps, **(settings or {})}
    return Scene(what, {name: value for name, value in given.items() if value is not None})
