# SPDX-License-Identifier: BSD-3-Clause
"""sphk.1, the man page, from the help of the commands. Usage: man_page.py SPHK FILE"""

import datetime
import os
import subprocess
import sys
from pathlib import Path

from help_tree import command_of


def roff(text):
    """Text as it stands: no line of it is a request, and hyphens can be copied."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\n".join("\\&" + line if line.startswith((".", "'")) else line for line in text.splitlines())


def verbatim(text):
    return f".nf\n{roff(text)}\n.fi\n"


def entries(options):
    for option in options:
        names = ", ".join(f"\\fB{roff(name)}\\fR" for name in option.names)
        argument = f" \\fI{roff(option.argument)}\\fR" if option.argument else ""
        notes = f" ({'; '.join(option.notes)})" if option.notes else ""
        yield f".TP\n{names}{argument}\n{roff(option.meaning + notes)}\n"


def section(command):
    """A command: what it does, its arguments and options, and what its help says below them."""
    words = " ".join(["sphk", *command.words])
    parts = [f".SS {roff(words)}\n{roff(command.summary)}.\n", *entries(command.positionals)]
    parts += entries(command.own_options())
    if command.footer:
        parts.append(f".PP\n{verbatim(command.footer)}")
    return "".join(parts)


def page(sphk):
    root = command_of(sphk)
    version = subprocess.run([sphk, "--version"], capture_output=True, text=True, check=True).stdout.split()
    built = datetime.date.fromtimestamp(os.stat(sphk).st_mtime)
    name, _, what = root.summary.partition(": ")
    return "".join([
        f'.TH SPHK 1 "{built}" "{" ".join(version[:2])}" "User Commands"\n',
        f".SH NAME\n{name} \\- {roff(what)}\n",
        f".SH SYNOPSIS\n.B sphk\n[\\fIOPTIONS\\fR] \\fICOMMAND\\fR ...\n.SH DESCRIPTION\n{verbatim(root.footer)}",
        ".SH OPTIONS\n", *entries(root.options),
        ".SH COMMANDS\n", *map(section, list(root.everyone())[1:]),
    ])


Path(sys.argv[2]).write_text(page(sys.argv[1]))
