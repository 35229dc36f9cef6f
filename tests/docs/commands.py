# SPDX-License-Identifier: BSD-3-Clause
"""Holds every `sphk` command in the pages, the README and the like against the program's own help: commands, options
and scenes are there. So are the files that they link to. Usage: commands.py SPHK"""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.append(str(ROOT / "cmake" / "packaging"))
from help_tree import command_of  # noqa: E402

BLOCK = re.compile(r"```(?:bash|console)\n(.*?)```", re.DOTALL)
CALL = re.compile(r"(?:^|;|\bdo\b)\s*(?:sphk|bash cmake/sphk\.sh) ((?:[^#;|&\n]|\|v\|)*)", re.MULTILINE)


TEXTS = [*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md"), *ROOT.glob(".github/**/*.md")]


def calls():
    """(file, words) of every command."""
    for path in TEXTS:
        for block in BLOCK.findall(path.read_text()):
            for words in CALL.findall(block):
                yield path.relative_to(ROOT), words.split()


def lost_links():
    """Sentences on links to files that are not there."""
    for path in TEXTS:
        for link in re.findall(r"\]\(<?([^)>]+)", path.read_text()):
            if "://" not in link and not (path.parent / link.partition("#")[0]).exists():
                yield f"{path.relative_to(ROOT)} links to {link}, which is not there"


def fault(words, root, scenes):
    """What the program would not take, or nothing."""
    commands = {command.words[0]: command for command in root.commands}
    if words[0] == "test" or words[0].startswith("--"):
        return None  # the script's own, and the program's
    if words[0] not in commands:
        return f"there is no command {words[0]}"
    taken = commands[words[0]].options + root.own_options()
    options = {name for option in taken for name in option.names}
    for word in words[1:]:
        if re.match(r"--?[a-z]", word) and word.split("=")[0] not in options:
            return f"sphk {words[0]} has no option {word}"
    what = words[1] if len(words) > 1 else ""
    if words[0] == "run" and re.fullmatch(r"[a-z][a-z0-9-]*", what) and what not in scenes:
        return f"there is no scene {what}"
    return None


def main():
    root = command_of(sys.argv[1])
    listed = subprocess.run([sys.argv[1], "list"], capture_output=True, text=True, check=True).stdout
    scenes = {line.split()[0] for line in listed.split("\n\n")[0].splitlines()[1:]}
    found = list(calls())
    assert len(found) > 60, f"only {len(found)} commands were found: has the fence changed?"
    faults = list(lost_links())
    for path, words in found:
        if what := fault(words, root, scenes):
            faults.append(f"{path}: sphk {' '.join(words)}: {what}")
    print("\n".join(faults) or f"{len(found)} commands are as the program has them, and links lead somewhere")
    sys.exit(len(faults) > 0)


main()
