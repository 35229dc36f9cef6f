# SPDX-License-Identifier: BSD-3-Clause
"""A virtual environment with packages from pip, made once."""

import subprocess
import sys
from pathlib import Path

SKIPPED = 77


def run_within(folder, packages, script):
    """Goes on within the environment; ends the program with SKIPPED where it cannot be made."""
    python = Path(folder) / "bin" / "python"
    stamp = Path(folder) / "packages.txt"
    if not stamp.exists() or stamp.read_text().splitlines() != packages:
        try:
            subprocess.run([sys.executable, "-m", "venv", "--clear", folder], check=True)
            install = ["pip", "install", "--quiet", "--disable-pip-version-check"]
            subprocess.run([python, "-m", *install, *packages], check=True)
        except (OSError, subprocess.CalledProcessError) as error:
            print(f"skipped: no environment with {', '.join(packages)} can be made: {error}")
            sys.exit(SKIPPED)
        stamp.write_text("\n".join(packages))
    sys.exit(subprocess.run([python, "-B", *script]).returncode)
