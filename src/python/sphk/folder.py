# SPDX-License-Identifier: BSD-3-Clause
"""Runs as they lie in their folders."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Sequence
from os import PathLike
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from . import _sphk, program
from .keys import table


class Picture:
    """An image file, which notebooks show."""

    def __init__(self, path):
        self.path = Path(path)

    def __fspath__(self):
        return str(self.path)

    def __repr__(self):
        return f"<sphk.Picture: {self.path}>"

    def _repr_png_(self):
        return self.path.read_bytes() if self.path.suffix == ".png" else None


class Run:
    """A run in its folder, as `sphk run` and Simulation.save leave it.

    run[-1]    a snapshot: the last one; len(run) of them, run.times
    history    its history.csv: a DataFrame where pandas is installed, else a dict of arrays
    info       its run.json: errors, conservation, costs, machine, warnings"""

    def __init__(self, folder, temporary=None):
        self.folder, self._temporary = Path(folder), temporary
        if not (self.folder / "scene.used.toml").is_file():
            raise _sphk.InputError(f"{self.folder} holds no run: name a folder that `sphk run` or Simulation.save "
                                   "filled")

    def __repr__(self):
        return f"<sphk.Run: {self.folder}, {len(self)} snapshots>"

    def __fspath__(self):
        return str(self.folder)

    @property
    def info(self) -> dict[str, Any]:
        return json.loads((self.folder / "run.json").read_text())

    @property
    def history(self) -> Any:
        return table(program.read_csv(self.folder / "history.csv"))

    @property
    def snapshots(self) -> list[Path]:
        """Paths of the snapshots, in the order of their times."""
        return sorted(self.folder.glob("snap_*.hdf5"))

    @property
    def times(self) -> list[float]:
        series = json.loads((self.folder / "run.hdf.series").read_text())
        return [entry["time"] for entry in series["files"]]

    def __len__(self):
        return len(self.snapshots)

    def __getitem__(self, number: int) -> Snapshot:
        return Snapshot(self.snapshots[number])

    def plot(self, exact: bool = True, out: str | PathLike | None = None, options: Sequence[str] = ()) -> Picture:
        """Draws the last snapshot, with the exact solution where the scene has one and `exact` asks for it, as `sphk
        plot` does. `out` names the file; further options are those of the program. Notebooks show what it returns."""
        if out is None:
            self._drawings = tempfile.TemporaryDirectory(prefix="sphk-")
            out = Path(self._drawings.name) / f"{self.folder.name}.png"
        program.call(["plot", self.folder, "--exact" if exact else "--no-exact", "--out", out, *options])
        picture = Picture(out)
        picture.run = self  # the file goes with it
        return picture


class Snapshot:
    """Fields of a snapshot, read with h5py when they are asked for: snapshot["Velocities"], rows sorted by id."""

    def __init__(self, path):
        self.path = Path(path)

    def __repr__(self):
        return f"<sphk.Snapshot: {self.path}, t = {self.time:.6g}>"

    def _open(self):
        try:
            import h5py
        except ImportError:
            raise ImportError("snapshots are read by h5py: pip install h5py") from None
        return h5py.File(self.path, "r")

    @property
    def time(self) -> float:
        with self._open() as file:
            return float(file["Header"].attrs["Time"].flat[0])

    def keys(self) -> list[str]:
        with self._open() as file:
            return list(file["PartType0"])

    def __getitem__(self, name: str) -> NDArray:
        with self._open() as file:
            gas = file["PartType0"]
            if name not in gas:
                raise KeyError(f'there is no field "{name}"; there are {", ".join(gas)}')
            return gas[name][:]


def load(folder: str | PathLike) -> Run:
    """Opens a run's folder."""
    return Run(folder)
