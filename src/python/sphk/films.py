# SPDX-License-Identifier: BSD-3-Clause
"""Films of runs."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from . import _sphk, program


def movie(runs: Any, field: str = "rho", path: str | os.PathLike = "movie.mp4", fps: float = 24,
          options: Sequence[str] = ()) -> Path:
    """A film of runs side by side on one scale, a picture for each of their snapshots: .mp4 (needs ffmpeg), .gif or
    .html. `runs`: folders, Runs or Simulations that were saved as they went on; one, a list, or a dict of names."""
    runs = list(runs.values()) if isinstance(runs, dict) else runs if isinstance(runs, (list, tuple)) else [runs]
    program.call(["movie", *map(_folder, runs), "--field", field, "--out", path, "--fps", fps, *options])
    return Path(path)


def _folder(run):
    folder = os.fspath(run) if isinstance(run, (str, os.PathLike)) else run.folder
    if folder is None:
        raise _sphk.InputError(f"movie: {run!r} has left no snapshots; save it as it goes on, as in "
                               'run(until=2, every={0.05: lambda sim: sim.save("kh")})')
    return folder
