# SPDX-License-Identifier: BSD-3-Clause
"""Draws what a work order (JSON on standard input) asks for, and prints the names of the files. The arguments are the
packages that this needs: exit code 86 where one of them is missing."""

import importlib.util
import json
import os
import sys

MISSING_PACKAGE = 86  # src/report/plot_script.cpp tries another Python, then names the packages

# The cache of matplotlib's fonts needs a folder that can be written.
if not os.access(os.path.expanduser("~"), os.W_OK):
    import tempfile

    os.environ.setdefault("MPLCONFIGDIR", tempfile.mkdtemp(prefix="sphk-plot-"))

if not all(importlib.util.find_spec(package) for package in sys.argv[1:]):
    sys.exit(MISSING_PACKAGE)

from .errors import draw_errors
from .field_map import draw_field_maps, draw_frames
from .gallery import draw_gallery
from .history import draw_conservation, draw_history, errors_at, read_history
from .kernels import draw_kernels
from .movie import draw_movie
from .pages import write_page
from .profiles import draw_one_field, draw_profiles, shared_limits
from .snapshot import Snapshot
from .stability import draw_stability
from .study import draw_speed, draw_study


def draw_one_field_of(work):
    name, items = work["field"], work["profiles"]
    errors = [errors_at(read_history(item["history"]), item["time"]).get(name) if item["history"] else None
              for item in items]
    draw_one_field([Snapshot(item) for item in items], errors, name, work["view"], work["out"])


def draw_run(work):
    """Snapshots of one run on one scale; one of them is held at a time."""
    history, items = read_history(work["history"]) if work["history"] else {}, work["snapshots"]
    shared = shared_limits(Snapshot(item) for item in items)
    for item in items:
        draw_profiles(Snapshot(item), errors_at(history, item["time"]), shared, item["out"])
    draw_frames([item for item in items if item["images"]], {})
    if work.get("history_out") and len(history.get("time", [])) > 1:
        draw_history(history, work["references"], items[-1], work["history_out"])


FIGURES = {  # by the key that only the work order of such a figure has
    "stability": draw_stability,
    "conservation": lambda work: draw_conservation(work["conservation"], work["out"]),
    "study": draw_study,
    "speed": draw_speed,
    "page": write_page,
    "gallery": lambda work: draw_gallery(work["gallery"], work["out"]),
    "kernels": lambda work: draw_kernels(work["kernels"], work["out"]),
    "errors": lambda work: draw_errors([Snapshot(item) for item in work["errors"]], work["out"]),
    "profiles": draw_one_field_of,
    "movie": draw_movie,
    "maps": lambda work: draw_field_maps(work["maps"], work["field"], work["view"], work["out"]),
    "frames": lambda work: draw_frames(work["frames"], {work["field"]: work["view"]}),
}

work = json.load(sys.stdin)
try:
    if work:
        next((draw for key, draw in FIGURES.items() if work.get(key)), draw_run)(work)
except OSError as problem:
    sys.exit(f"{problem.filename}: {problem.strerror}")
