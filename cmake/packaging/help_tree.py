# SPDX-License-Identifier: BSD-3-Clause
"""What the command line says of itself: the help of every command, as data."""

import re
import subprocess
from dataclasses import dataclass, field

COLUMN = 30  # where meanings begin, on the line of the name or, below a longer one, on the next


@dataclass
class Option:
    """An option or a positional argument."""

    names: list
    argument: str  # what follows it, such as KEY=VALUE; "" for a switch
    notes: list  # what else the command says of it
    meaning: str


@dataclass
class Command:
    words: list  # of the command line, without the program
    summary: str
    usage: str
    positionals: list = field(default_factory=list)
    options: list = field(default_factory=list)
    footer: str = ""
    commands: list = field(default_factory=list)

    def own_options(self):
        """Without those that every command has for itself."""
        return [option for option in self.options if not {"--help", "--version"} & set(option.names)]

    def everyone(self):
        """Itself and all below it."""
        yield self
        for command in self.commands:
            yield from command.everyone()


def option_of(name, meaning):
    words, excluded = re.match(r"(.*?)(?: Excludes: (.*))?$", name).groups()
    notes = [f"not with {excluded}"] if excluded else []
    names, _, rest = words.partition(" ")
    names = [re.sub(r"\{.*\}", "", one) for one in names.split(",")]
    if "REQUIRED" in rest:
        notes.insert(0, "required")
    bounds = re.search(r"in \[(.*) - (.*)\]", rest)
    if bounds:
        notes.append("{} to {}".format(*bounds.groups()))
    if ":POSITIVE" in rest:
        notes.append("above 0")
    argument = re.sub(r":(INT|POSITIVE|FLOAT)\b.*| in \[.*| x \d+| REQUIRED|REQUIRED", "", rest).strip()
    return Option(names, argument, notes, meaning)


def rows(lines):
    """(name, meaning) of the rows of a section."""
    found = []
    for line, following in zip(lines, [*lines[1:], ""]):
        name, meaning = line[:COLUMN].strip(), line[COLUMN:].strip()
        if not name:
            found[-1][1] = f"{found[-1][1]} {meaning}".strip()
        elif following.startswith(" " * COLUMN) and line[COLUMN - 2 : COLUMN] != "  ":
            found.append([line.strip(), ""])
        else:
            found.append([name, meaning])
    return found


def sections(text):
    """The paragraphs of a help text by their heading; those without one under ""."""
    found = {"": []}
    for paragraph in text.strip().split("\n\n"):
        heading, _, rest = paragraph.strip("\n").partition("\n")
        if heading in ("Positionals:", "Options:", "Subcommands:"):
            found[heading] = rest.splitlines()
        else:
            found[""].append(paragraph.strip("\n"))
    return found


def command_of(program, words=()):
    """The command of these words with all below it."""
    text = subprocess.run([program, *words, "--help"], capture_output=True, text=True, check=True).stdout
    parts = sections(text)
    summary, _, usage = parts[""][0].partition("\nUsage: ")
    command = Command(list(words), summary.strip(), usage.strip(), footer="\n\n".join(parts[""][1:]))
    command.positionals = [option_of(*row) for row in rows(parts.get("Positionals:", []))]
    command.options = [option_of(*row) for row in rows(parts.get("Options:", []))]
    command.commands = [command_of(program, (*words, name)) for name, _ in rows(parts.get("Subcommands:", []))]
    return command
