# SPDX-License-Identifier: BSD-3-Clause
"""Pages that the program writes: its commands, scenes, schemes and keys, as it tells them itself. conf.py puts each in
the place of the line `% generated: NAME` of a page.
To see one: SPHK_PROGRAM=build/openmp/bin/sphk python3 docs/generate.py commands"""

import os
import re
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parent.parent
PYTHON = ROOT / "src" / "python"
sys.path.insert(0, str(ROOT / "cmake" / "packaging"))
from help_tree import command_of  # noqa: E402

LABEL = re.compile(r"^  (\S[\w ]*?)  +(\S.*)$")  # "  passes       kick and drift -> ..."
SHARED = ("sph", "time", "output", "ic", "units", "gravity")  # sections whose keys every scene and scheme have


def said(*words):
    return subprocess.run([os.environ["SPHK_PROGRAM"], *words], capture_output=True, text=True, check=True).stdout


def cell(text):
    """Text as it stands, in a cell of a table."""
    return re.sub(r"([\\|*_<>$`~\[\]])", r"\\\1", text)


def code(text):
    return f"`{text}`" if text else ""


def table(heads, lines):
    rows = [heads, ["---"] * len(heads), *lines]
    return "".join("| " + " | ".join(row) + " |\n" for row in rows)


def option_rows(options):
    for option in options:
        names = ", ".join(code(f"{name} {option.argument}".strip().replace("|", "\\|")) for name in option.names)
        notes = f" ({cell('; '.join(option.notes))})" if option.notes else ""
        yield [names, cell(option.meaning) + notes]


def commands():
    """Every command with its options, and what its help says below them."""
    tree = command_of(os.environ["SPHK_PROGRAM"])
    pages = ["Every command takes these as well:\n\n" + table(["option", "what"], option_rows(tree.own_options()))]
    for command in list(tree.everyone())[1:]:
        words = " ".join(["sphk", *command.words])
        usage = re.sub(r"\(\d+x\)", "", command.usage)
        pages.append(f"## {words}\n\n{cell(command.summary[0].upper() + command.summary[1:])}.\n\n```\n{usage}\n```\n")
        if command.positionals:
            pages.append(table(["argument", "what"], option_rows(command.positionals)))
        if command.own_options():
            pages.append(table(["option", "what"], option_rows(command.own_options())))
        if command.footer:
            pages.append(f"```text\n{command.footer}\n```\n")
    return "\n".join(pages)


def listed():
    """The tables of `sphk list`: scenes, then schemes, each as (name, what it is)."""
    tables = []
    for block in said("list").split("\n\n")[:2]:
        head, *lines = block.splitlines()
        column = head.index("what it is")
        tables.append([(line.split()[0], line[column:]) for line in lines])
    return tables


def shown(*words):
    """What `sphk show` says: its notes by label, and its keys as (key, value, who set it, meaning)."""
    notes, keys, label, columns = {}, [], None, None
    for line in said("show", *words).splitlines()[1:]:
        if line.startswith("  key "):
            columns = [line.index(head) for head in ("value", "set by", "meaning")]
        elif columns:
            value, by, meaning = columns
            key = line.split()[0]
            value = max(value, 3 + len(key))
            keys.append((key, line[value:by].strip(), line[by:meaning].strip(), line[meaning:]))
        elif line.startswith("               ") and label:
            notes[label].append(line.strip())
        elif found := LABEL.match(line):
            label = found[1]
            notes[label] = [found[2]]
    return notes, keys


def key_table(keys):
    return table(["key", "default", "meaning"], [[code(key), code(value), cell(text)] for key, value, _, text in keys])


def bullets(lines):
    return "".join(f"- {cell(line)}\n" for line in lines) + "\n"


def scenes():
    """Every scene: what it is, how it differs from the paper, its own keys and those that it sets."""
    pages = []
    for name, summary in listed()[0]:
        notes, keys = shown(name)
        pages.append(f"## {name}\n\n{cell(summary)}\n\nBy default {cell(notes['particles'][0])}; "
                     f"{cell(notes['scheme'][0])}.\n")
        if "differs" in notes:
            pages.append("Differs from the paper:\n\n" + bullets(notes["differs"]))
        own = [row for row in keys if row[0].startswith("scene.")]
        if own:
            pages.append(key_table(own))
        chosen = [row for row in keys if row[2] == "scene" and not row[0].startswith("scene.")]
        if chosen:
            pages.append("It sets " + ", ".join(f"`{key} = {value}`" for key, value, _, _ in chosen) + ".\n")
    return "\n".join(pages)


def schemes():
    """Every scheme: its step, its terms, what it costs and its own numbers."""
    pages = []
    for name, summary in listed()[1]:
        notes, keys = shown("uniform", "-n", "8", "--scheme", name, "--set", "scene.lattice=cubic")
        own = [row for row in keys if row[0].split(".")[0] not in (*SHARED, "scene")]
        steps = {key: value for key, value, _, _ in keys}
        pages.append(f"## {name}\n\n{cell(summary)}. In 3D: {cell(notes['scheme'][0].partition(', ')[2])}; "
                     f"Courant number {steps['time.courant']}, {code(steps['time.steps'])} time-steps; "
                     f"{cell(notes['cost'][0])}.\n")
        if "differs" in notes:
            pages.append("Differs from the paper:\n\n" + bullets(notes["differs"]))
        pages.append(f"A step: {cell(notes['passes'][0].replace('->', '→'))}.\n\nTerms:\n\n" + bullets(notes["terms"]))
        if own:
            pages.append(key_table(own))
    return "\n".join(pages)


def keys():
    """The keys that every run has, by section."""
    rows = shown("uniform", "-n", "8")[1]
    return "\n".join(f"## [{section}]\n\n" + key_table([row for row in rows if row[0].split(".")[0] == section])
                     for section in SHARED)


def python():
    """The Python package by its docstrings, where its sources are."""
    if not (PYTHON / "sphk" / "simulation.py").exists():
        return "There is no Python package in this tree."
    sections = {
        "Gas": ["class:: Particles"],
        "Simulations": ["class:: Simulation", "class:: fields.Fields"],
        "Arranging particles": ["module:: ic"],
        "Scenes and runs": ["function:: scene", "class:: Scene", "function:: load", "class:: Run", "class:: folder.Snapshot"],
        "Films and studies": ["function:: movie", "function:: study"],
    }
    pages = []
    for title, items in sections.items():
        directives = []
        for item in items:
            kind, _, name = item.partition(":: ")
            members = "" if kind == "function" else "   :members:\n"
            directives.append(f".. auto{kind}:: sphk.{name}\n{members}")
        pages.append(f"## {title}\n\n```{{eval-rst}}\n" + "\n".join(directives) + "```\n")
    return "\n".join(pages)


PAGES = {function.__name__: function for function in (commands, scenes, schemes, keys, python)}

if __name__ == "__main__":
    print(PAGES[sys.argv[1]]())
