#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause

# bash sphk_sh.sh PROJECT WORK
# cmake/sphk.sh stops with a clear sentence when something is missing. Stand-ins for dpkg-query, id, sudo and apt-get
# play a Debian machine on which nothing is installed; the script runs on a copy, so it configures nothing here.
set -euo pipefail
project=$1 work=$2
failures=0

rm -rf "$work"
mkdir -p "$work/bin" "$work/project/cmake/presets"
cp "$project/cmake/sphk.sh" "$work/project/cmake/"
cp "$project"/cmake/presets/*.cmake "$work/project/cmake/presets/"

# stub NAME COMMANDS: a program of that name, found before the real one.
stub() {
  printf '#!/bin/bash\n%s\n' "$2" >"$work/bin/$1"
  chmod +x "$work/bin/$1"
}

# expect NAME CODE SENTENCE [VARIABLE=VALUE...]: from another folder, without a terminal.
expect() {
  local name=$1 code=$2 sentence=$3 output status=0
  shift 3
  output=$(cd / && env PATH="$work/bin:$PATH" "$@" bash "$work/project/cmake/sphk.sh" list </dev/null 2>&1) || status=$?
  if [[ $status != "$code" || $output != *"$sentence"* ]]; then
    echo "$name: exit code $status, expected $code, and the words '$sentence' in:"
    echo "$output"
    failures=$((failures + 1))
  fi
}

stub dpkg-query 'exit 1'
stub apt-get "echo apt-get \"\$@\" >>'$work/apt.log'"
stub id 'echo 1000'
stub sudo 'exit 1'
expect "no sudo: the exact command" 1 "sudo apt-get update && sudo apt-get install ca-certificates cmake g++"
[[ ! -e $work/apt.log ]] || { echo "apt-get was called without leave"; failures=$((failures + 1)); }

stub id 'echo 0'
stub cmake 'exit 1'
expect "root: installs, and says that cmake failed" 1 "cmake could not configure"
grep -q -- '-y --no-install-recommends install .*libhdf5-dev' "$work/apt.log" ||
  { echo "apt-get was not asked for libhdf5-dev"; failures=$((failures + 1)); }

stub apt-get 'exit 100'
expect "root: apt-get fails" 1 "apt-get could not install them"

stub apt-get 'exit 0'
expect "unknown preset" 1 "SPHK_PRESET can be: cuda debug openmp serial thread" SPHK_PRESET=fast

exit $((failures > 0))
