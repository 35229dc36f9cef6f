# SPDX-License-Identifier: BSD-3-Clause
"""The man page and the completion that are made from the program's help: the page has every command and option and no
fault that mandoc knows; bash completes words by it. Usage: help_files.py SPHK"""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

PACKAGING = Path(__file__).resolve().parent.parent.parent / "cmake" / "packaging"
sys.path.append(str(PACKAGING))
from help_tree import command_of  # noqa: E402

# What is typed, and the one word that is meant.
TYPED = {
    "sphk ru": "run",
    "sphk run --sch": "--scheme",
    "sphk run --scheme gad": "gadget2",
    "sphk run --precision m": "mixed",
    "sphk run gre": "gresho",
    "sphk ic ch": "check",
    "sphk run sod --json": "--json-log",
}


def script(name, *words):
    subprocess.run([sys.executable, "-B", PACKAGING / name, *words], check=True)


def check_page(sphk, folder):
    page = folder / "sphk.1"
    script("man_page.py", sphk, page)
    text = page.read_text().replace("\\-", "-")
    for command in command_of(sphk).everyone():
        assert " ".join(["sphk", *command.words]) in text, f"no {command.words}"
        for name in [name for option in command.options for name in option.names]:
            assert name in text, f"no {name}"
    if shutil.which("mandoc"):
        subprocess.run(["mandoc", "-Tlint", "-Wwarning", page], check=True)
    if shutil.which("man"):
        read = subprocess.run(["man", "--warnings", "-l", page], capture_output=True, text=True, check=True)
        assert not read.stderr, read.stderr
        assert "continues bit by bit" in " ".join(read.stdout.split()), read.stdout


def completed(file, line):
    """What bash makes of a line whose last word is being typed."""
    lines = 'source "$0"; COMP_WORDS=($1); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _sphk; echo "${COMPREPLY[@]}"'
    said = subprocess.run(["bash", "-c", lines, file, line], capture_output=True, text=True, check=True)
    assert not said.stderr, said.stderr
    return said.stdout.split()


def check_completion(sphk, folder):
    script("completion.py", sphk, "bash", folder / "sphk")
    for line, word in TYPED.items():
        assert completed(folder / "sphk", line) == [word], f"{line}: {completed(folder / 'sphk', line)}, not {word}"
    assert completed(folder / "sphk", "sphk nothing-like-it") == []
    registers = ["bash", "-c", 'source "$0"; complete -p sphk', folder / "sphk"]
    assert "_sphk" in subprocess.run(registers, capture_output=True, text=True, check=True).stdout
    script("completion.py", sphk, "zsh", folder / "_sphk")
    if shutil.which("zsh"):
        subprocess.run(["zsh", "-n", folder / "_sphk"], check=True)


with tempfile.TemporaryDirectory() as name:
    check_page(sys.argv[1], Path(name))
    check_completion(sys.argv[1], Path(name))
