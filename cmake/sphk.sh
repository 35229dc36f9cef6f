#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause

# bash cmake/sphk.sh run SCENE... | test [ctest option...] | any other sub-command of sphk
#
# Installs the Debian packages that are missing (as root, or with a sudo that asks no password), gets Kokkos,
# configures, builds what has changed, and runs. Works from any folder and without a terminal. The program is linked into
# ~/.local/bin, as `sphk`, where nothing else has that name. What apt, CMake and the compiler say goes to build/*.log.
#   SPHK_PRESET  a name in cmake/presets (openmp), each with its own build folder
#   SPHK_JOBS    compilers at a time (one a core, 2 GB of memory each)
set -euo pipefail

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=${SPHK_PRESET:-openmp}
build="$project/build/$preset"
packages=(cmake g++ ninja-build libhdf5-dev libcli11-dev libtoml11-dev libfmt-dev nlohmann-json3-dev libeigen3-dev
  libgtest-dev libbenchmark-dev ca-certificates python3 python3-pip python3-matplotlib python3-jinja2 python3-h5py)

say() { echo "sphk: $*" >&2; }
stop() { say "$@"; exit 1; }

# logged LOG COMMAND...: the command's words go to build/LOG; the end of them to the terminal where it fails.
logged() {
  local log="$build/$1"
  shift
  mkdir -p "$build"
  if ! "$@" </dev/null >"$log" 2>&1; then
    tail -n 25 "$log" >&2
    say "the whole log is $log"
    return 1
  fi
}

# The packages of the list that are not installed, one a line.
missing_packages() {
  comm -23 <(printf '%s\n' "${packages[@]}" | sort) \
    <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null | sed -n 's/^installed //p' | sort)
}

install_packages() {
  command -v apt-get >/dev/null || return 0  # not Debian: cmake will name what it does not find
  local missing
  missing=$(missing_packages | xargs)
  [[ -n $missing ]] || return 0
  local apt=(apt-get) by_hand="sudo apt-get update && sudo apt-get install $missing"
  if [[ $(id -u) != 0 ]]; then
    sudo -n true 2>/dev/null || stop "these Debian packages are missing, and installing them needs a password. Run
  $by_hand
and then this command again."
    apt=(sudo -n apt-get)
  fi
  say "installing packages, a minute or two: $missing"
  # shellcheck disable=SC2086  # one word a package
  { logged packages.log "${apt[@]}" -qq update &&
    logged packages.log "${apt[@]}" -qq -y --no-install-recommends install $missing; } ||
    stop "apt-get could not install them. Mend what it says above, run
  $by_hand
and then this command again."
}

configure() {
  [[ -f $project/cmake/presets/$preset.cmake ]] ||
    stop "there is no preset '$preset'; SPHK_PRESET can be: $(cd "$project/cmake/presets" && ls -- *.cmake | sed 's/\.cmake$//' | xargs)"
  command -v cmake >/dev/null || stop "cmake is missing: install cmake 3.24 or newer, a C++20 compiler and ninja or make"
  [[ -f $build/build.ninja || -f $build/Makefile ]] && return 0  # cmake runs by itself when a file of it changes
  local generator=()
  command -v ninja >/dev/null && generator=(-G Ninja)
  say "configuring, and compiling Kokkos the first time, up to a minute"
  logged configure.log cmake "${generator[@]}" -C "$project/cmake/presets/$preset.cmake" -S "$project" -B "$build" ||
    stop "cmake could not configure; the reason is above"
}

jobs() {
  local cores memory_kb
  cores=$(getconf _NPROCESSORS_ONLN)
  memory_kb=$(sed -n 's/^MemAvailable: *\([0-9]*\) kB/\1/p' /proc/meminfo)
  local by_memory=$((memory_kb / 2000000))
  echo $((by_memory < 1 ? 1 : by_memory < cores ? by_memory : cores))
}

# build TARGET HOW_LONG: says nothing when nothing has changed.
build_target() {
  if [[ -f $build/build.ninja ]] && ninja -C "$build" -n "$1" 2>/dev/null | grep -q 'no work to do'; then
    return 0
  fi
  say "compiling $1, $2 the first time"
  logged build.log cmake --build "$build" --parallel "${SPHK_JOBS:-$(jobs)}" --target "$1" ||
    stop "the build failed; the first error above or in the log says where"
}

# Makes `sphk` a command, or says how to call it in what it prints (SPHK_COMMAND).
link_command() {
  local link="$HOME/.local/bin/sphk"
  if [[ ! -e $link || -L $link ]]; then
    mkdir -p "$HOME/.local/bin" 2>/dev/null && ln -sfn "$build/bin/sphk" "$link" 2>/dev/null || true
  fi
  [[ $(command -v sphk) -ef $build/bin/sphk ]] || export SPHK_COMMAND="bash $0"
}

[[ $# -gt 0 ]] || set -- --help
install_packages
configure
if [[ $1 == test ]]; then
  shift
  build_target all "some 20 minutes"
  exec ctest --test-dir "$build" --output-on-failure --label-exclude "long|readers|docs|python|arm64" "$@"
fi
build_target sphk "two minutes"
link_command
exec "$build/bin/sphk" "$@"
