"""The virtual environment with today's readers, made once."""

import subprocess
import sys
from pathlib import Path

# numpy: yt 4.4.3 turns SWIFT's one-element attributes into numbers in a way that newer ones refuse.
PACKAGES = ["yt", "swiftsimio", "pynbody", "vtk", "h5py", "numpy<2.4"]
SKIPPED = 77


def run_within(folder, script):
    """Goes on within the environment; ends the program with SKIPPED where it cannot be made."""
    python = Path(folder) / "bin" / "python"
    stamp = Path(folder) / "packages.txt"
    if not stamp.exists() or stamp.read_text().split() != PACKAGES:
        try:
            subprocess.run([sys.executable, "-m", "venv", "--clear", folder], check=True)
            subprocess.run([python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *PACKAGES], check=True)
        except (OSError, subprocess.CalledProcessError) as error:
            print(f"skipped: no environment with {', '.join(PACKAGES)} can be made: {error}")
            sys.exit(SKIPPED)
        stamp.write_text("\n".join(PACKAGES))
    sys.exit(subprocess.run([python, "-B", *script]).returncode)
