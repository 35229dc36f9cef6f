# SPDX-License-Identifier: BSD-3-Clause
"""The environment in which pages are built and checked: docs/requirements.txt."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.append(str(ROOT / "tests"))
from pip_environment import SKIPPED, run_within  # noqa: E402, F401


def enter(folder):
    """Goes on within the environment, where this is not it."""
    if sys.argv[-1] != "within":
        lines = (ROOT / "docs" / "requirements.txt").read_text().splitlines()
        run_within(folder, [line for line in lines if line and not line.startswith("#")], [*sys.argv, "within"])
