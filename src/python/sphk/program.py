# SPDX-License-Identifier: BSD-3-Clause
"""The program `sphk`, which is in the package."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

from . import _sphk
from .keys import key_texts, table
from .progress import Progress

PROGRAM = Path(_sphk.__file__).parent / "bin/sphk"

# Exit codes of the program.
_ERRORS = {2: _sphk.InputError, 3: _sphk.NumericsError}


def environment():
    """The program draws with this Python."""
    return {**os.environ, "SPHK_PYTHON": sys.executable}


def settings_of(keys):
    """Keys as options of the program."""
    return [word for name, text in key_texts(keys) for word in ("--set", f"{name}={text}")]


def call(words, take_line=None):
    """Runs a command of the program, and hands on every line that it prints; returns them. What it ends with becomes an
    exception with its own sentence; KeyboardInterrupt goes to it as well, and it ends as it does on a terminal."""
    lines = []
    with subprocess.Popen([PROGRAM, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          env=environment()) as process:
        try:
            for line in process.stdout:
                lines.append(line.rstrip("\n"))
                if take_line:
                    take_line(lines[-1])
            said = process.stderr.read()
        except KeyboardInterrupt:
            process.send_signal(signal.SIGINT)
            process.stdout.read()
            raise
    if process.returncode not in (0, 75):
        raise _ERRORS.get(process.returncode, _sphk.DeviceError)(_sentence(said, lines))
    return lines


def _sentence(said, lines):
    if lines and lines[-1].startswith('{"error"'):
        return json.loads(lines[-1])["error"]
    return said.strip().removeprefix("error: ")


def run(what, keys, folder, *, overwrite=False, threads=None, progress=False):
    """`sphk run` into a folder; returns what it has to say."""
    words = ["run", what, "--json-log", "--out", folder, *settings_of(keys)]
    words += ["--overwrite"] * bool(overwrite) + ["--threads", threads] * bool(threads)
    bar = Progress(str(what), 0, 1, progress)

    def take(line):
        report = json.loads(line)
        if "end" in report:
            bar.tell(report["time"], report["end"], report["updates_per_second"], report["seconds_left"])

    try:
        lines = call(words, take)
    finally:
        bar.end_line()
    return [message for line in lines if (message := json.loads(line).get("message"))]


def study(what, *, vary=None, settings=None, norm=None, repeat=None, budget=None, target=None, max_time=None,
          threads=None, out=None, report=None):
    """Error against run time over every combination of what is listed, as `sphk study` does: a DataFrame with a row for
    each point (a dict of lists without pandas).

    what    a scene with a known solution, a study file (*.toml) or a preset
    vary    {key: values}, such as {"sph.scheme": ["sph", "sphs"], "scene.n": [32, 64]}
    out     its folder, which keeps what is done; SCENE-study where left out
    report  an HTML page of it, by that name"""
    words = ["study", what, *settings_of(settings or {})]
    for name, values in (vary or {}).items():
        words += ["--vary", f"{name}={','.join(text for _, text in key_texts(dict(enumerate(values))))}"]
    options = {"norm": norm, "repeat": repeat, "budget": budget, "target": target, "max-time": max_time,
               "threads": threads, "out": out, "report": report}
    words += [word for name, value in options.items() if value is not None for word in (f"--{name}", value)]
    call(words)
    return table(read_csv(Path(out or f"{Path(what).stem}-study") / "study.csv"))


def read_csv(path):
    """Columns by name, as arrays of numbers where all are; others as lists of words."""
    import csv

    import numpy as np

    with open(path, newline="") as file:
        names, *rows = csv.reader(file)
    columns = {}
    for name, *values in zip(names, *rows):
        try:
            columns[name] = np.array(values, float)
        except ValueError:
            columns[name] = values
    return columns
