# SPDX-License-Identifier: BSD-3-Clause
"""Builds a wheel of a build folder's libraries and some schemes, installs it in a bare environment, and tries it from
another folder. Usage: python.py SOURCE BUILD CMAKE KOKKOS"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77
MODULES = ["sph_1d", "sph_2d", "sphs_2d"]
TOOLS = ["scikit-build-core>=0.10", "nanobind>=2.2", "ninja"]  # of the wheel
TRIED_WITH = ["pytest", "h5py", "matplotlib", "pandas", "nbconvert", "ipykernel"]
HERE = Path(__file__).parent


def environment(folder, packages):
    """A virtual environment with packages, made once."""
    python, stamp = folder / "bin" / "python", folder / "packages.txt"
    if not stamp.exists() or stamp.read_text().split("\n") != packages:
        try:
            subprocess.run([sys.executable, "-m", "venv", "--clear", folder], check=True)
            subprocess.run([python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *packages],
                           check=True)
        except (OSError, subprocess.CalledProcessError) as error:
            print(f"skipped: no environment with {', '.join(packages)} can be made: {error}")
            sys.exit(SKIPPED)
        stamp.write_text("\n".join(packages))
    return python


def main(source, build, cmake, kokkos):
    build = Path(build)
    subprocess.run([cmake, "--build", build, "--target", "sphk", *MODULES], check=True)
    makes = environment(build / "python-tools", TOOLS)
    tries = environment(build / "python-bare", TRIED_WITH)
    wheels = build / "wheels"
    tools = {**os.environ, "PATH": f"{makes.parent}:{os.environ['PATH']}"}
    subprocess.run([makes, "-m", "pip", "wheel", "--quiet", "--no-deps", "--no-build-isolation", "--wheel-dir", wheels,
                    f"--config-settings=cmake.define.SPHK_BUILT={build}",
                    f"--config-settings=cmake.define.Kokkos_ROOT={kokkos}", f"--config-settings=build-dir={build}/wheel",
                    source], check=True, env=tools)
    wheel = max(wheels.glob("sphk-*.whl"), key=lambda file: file.stat().st_mtime)
    subprocess.run([tries, "-m", "pip", "install", "--quiet", "--force-reinstall", "--no-deps", wheel], check=True)
    with tempfile.TemporaryDirectory() as elsewhere:
        tests = [tries, "-B", "-m", "pytest", "-q", "-p", "no:cacheprovider", "--rootdir", elsewhere, HERE]
        notebooks = {**os.environ, "SPHK_NOTEBOOKS": str(Path(source) / "docs/notebooks")}
        return subprocess.run(tests, cwd=elsewhere, env=notebooks).returncode


sys.exit(main(*sys.argv[1:]))
