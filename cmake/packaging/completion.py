# SPDX-License-Identifier: BSD-3-Clause
"""Completion of bash or zsh from the help of the commands. Usage: completion.py SPHK bash|zsh FILE"""

import re
import subprocess
import sys
from pathlib import Path

from help_tree import command_of

FILES = re.compile(r"TEXT|DIR|FILE")  # arguments that may be files


def names_listed(sphk):
    """Scenes and schemes, by `sphk list`."""
    tables = subprocess.run([sphk, "list"], capture_output=True, text=True, check=True).stdout.split("\n\n")
    return [[line.split()[0] for line in table.splitlines()[1:]] for table in tables[:2]]


def choices(option, schemes):
    """The words that an option takes, where it takes words."""
    if "--scheme" in option.names:
        return schemes
    words = option.argument.split("|")
    return [word for word in words if word.islower()] if len(words) > 1 else []


def first_words(command, scenes):
    """What may stand behind a command: those below it, or scenes."""
    takes_scenes = any("scene" in option.meaning for option in command.positionals)
    return [below.words[-1] for below in command.commands] + (scenes if takes_scenes else [])


BASH = """# bash completion for sphk
_sphk() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} command="" options="" words="" k
  for ((k = 1; k < COMP_CWORD; ++k)); do
    case "$command ${{COMP_WORDS[k]}}" in
      {commands}) command+=" ${{COMP_WORDS[k]}}" ;;
    esac
  done
  case "$command" in
{cases}
  esac
  case "$command $before" in
{arguments}
  esac
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  fi
}}
complete -o default -F _sphk sphk
"""


def bash(root, scenes, schemes):
    cases, arguments = [], []
    for command in root.everyone():
        name = "".join(f" {word}" for word in command.words)
        taken = command.options if command is root else command.options + root.own_options()
        options = " ".join(name for option in taken for name in option.names)
        words = " ".join(first_words(command, scenes))
        cases.append(f'    "{name}") options="{options}" words="{words}" ;;')
        for option in taken:
            pattern = "|".join(f'"{name} {one}"' for one in option.names)
            if found := choices(option, schemes):
                arguments.append(f'    {pattern}) options="" words="{" ".join(found)}" ;;')
            elif option.argument:
                arguments.append(f'    {pattern}) options="" words="" ;;')
    commands = "|".join(f'"{"".join(f" {word}" for word in command.words)}"' for command in list(root.everyone())[1:])
    return BASH.format(commands=commands, cases="\n".join(cases), arguments="\n".join(arguments))


def zsh_text(text):
    return re.sub(r"([\[\]:\\])", r"\\\1", text).replace("'", "'\\''")


def zsh_spec(option, schemes):
    """An option, as _arguments takes it."""
    names, meaning = option.names, zsh_text(option.meaning)
    action = "" if not option.argument else f":{zsh_text(option.argument)}:"
    if found := choices(option, schemes):
        action += f"({' '.join(found)})"
    elif FILES.match(option.argument):
        action += "_files"
    if "once for each" in option.meaning:
        return f"'*{names[0]}[{meaning}]{action}'"
    head = f"'({' '.join(names)})'{{{','.join(names)}}}'" if len(names) > 1 else f"'{names[0]}"
    return f"{head}[{meaning}]{action}'"


def zsh_function(command, root, scenes, schemes):
    name = "_".join(["_sphk", *command.words])
    taken = command.options if command is root else command.options + root.own_options()
    specs = [zsh_spec(option, schemes) for option in taken]
    if command.commands:
        listed = " ".join(f"'{below.words[-1]}:{zsh_text(below.summary)}'" for below in command.commands)
        cases = " ".join(f"{below.words[-1]}) {name}_{below.words[-1]} ;;" for below in command.commands)
        body = [f"  local -a commands=({listed})", "  local state",
                "  _arguments -C " + " ".join([*specs, "'1:command:->command'", "'*::word:->words'"]),
                "  case $state in", "    command) _describe command commands ;;",
                f"    words) case $words[1] in {cases} esac ;;", "  esac"]
    else:
        if command.positionals:
            scenes_or_files = '{_alternative "scenes:scene:(%s)" "files:file:_files"}' % " ".join(scenes)
            action = scenes_or_files if first_words(command, scenes) else "_files"
            specs.append(f"'*:{command.positionals[0].names[0]}:{action}'")
        body = ["  _arguments " + " ".join(specs)]
    return "\n".join([f"{name}() {{", *body, "}"])


def zsh(root, scenes, schemes):
    functions = [zsh_function(command, root, scenes, schemes) for command in root.everyone()]
    return "\n".join(["#compdef sphk", *functions, '_sphk "$@"', ""])


if __name__ == "__main__":
    writer = {"bash": bash, "zsh": zsh}[sys.argv[2]]
    Path(sys.argv[3]).write_text(writer(command_of(sys.argv[1]), *names_listed(sys.argv[1])))
