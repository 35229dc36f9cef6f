# SPDX-License-Identifier: BSD-3-Clause
"""Does what a page of the tutorial says, as printed: its files are written and its commands run, in an empty folder beside
docs/. Usage: tutorial.py SPHK PAGE"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
BLOCK = re.compile(r"```(bash|toml)\n(.*?)```", re.DOTALL)
PYTHON = "/usr/bin/python3"  # Debian's, which has h5py from the packages of the set-up script
SKIPPED = 77


def steps(text):
    """The page's blocks in their order: ("toml", its file's name, its text) or ("bash", "", its commands)."""
    for block in BLOCK.finditer(text):
        named = re.findall(r"`(\w+\.toml)`", text[: block.start()])
        yield block[1], named[-1] if block[1] == "toml" else "", block[2]


def main():
    if subprocess.run([PYTHON, "-c", "import h5py, matplotlib"], capture_output=True).returncode:
        print(f"skipped: {PYTHON} has no h5py and matplotlib")
        sys.exit(SKIPPED)
    page = ROOT / "docs" / "tutorial" / sys.argv[2]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "docs").symlink_to(ROOT / "docs")
        (folder / "bin").mkdir()
        (folder / "bin" / "python3").symlink_to(PYTHON)
        (folder / "bin" / "sphk").symlink_to(sys.argv[1])
        environment = {**os.environ, "PATH": f"{folder / 'bin'}:{os.environ['PATH']}"}
        done = 0
        for kind, file, text in steps(page.read_text()):
            if kind == "toml":
                (folder / file).write_text(text)
                text = f"sphk run {file} --out {Path(file).stem}-by-file"
            subprocess.run(["bash", "-exo", "pipefail", "-c", text], cwd=folder, env=environment, check=True)
            done += 1
        assert done > 0, f"{page} has no block that is run: has the fence changed?"
        runs = sorted(path.parent.name for path in folder.glob("*/run.json"))
        assert runs, "no run has left its folder"
        print(f"{done} blocks of {page.name} made {', '.join(runs)}")


main()
