#!/usr/bin/env bash
# bash cmake/sphk.sh run SCENE... | test [ctest option...] | any other sub-command of sphk
#
# Installs the Debian packages that are missing (as root, or with a sudo that asks no password), gets Kokkos,
# configures, builds what has changed, and runs. Works from any folder and without a terminal.
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
  say "installing with apt-get: $missing"
  # shellcheck disable=SC2086  # one word a package
  { "${apt[@]}" -qq update && "${apt[@]}" -qq -y --no-install-recommends install $missing; } </dev/null >&2 ||
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
  mkdir -p "$build"
  say "configuring in $build"
  if ! cmake "${generator[@]}" -C "$project/cmake/presets/$preset.cmake" -S "$project" -B "$build" </dev/null 2>&1 |
    tee "$build/configure.log" | sed -un 's/^-- sphk:/sphk:/p' >&2; then
    cat "$build/configure.log" >&2
    stop "cmake could not configure; the reason is above and in $build/configure.log"
  fi
}

jobs() {
  local cores memory_kb
  cores=$(getconf _NPROCESSORS_ONLN)
  memory_kb=$(sed -n 's/^MemAvailable: *\([0-9]*\) kB/\1/p' /proc/meminfo)
  local by_memory=$((memory_kb / 2000000))
  echo $((by_memory < 1 ? 1 : by_memory < cores ? by_memory : cores))
}

# build TARGET: says nothing when nothing has changed.
build_target() {
  if [[ -f $build/build.ninja ]] && ninja -C "$build" -n "$1" 2>/dev/null | grep -q 'no work to do'; then
    return 0
  fi
  cmake --build "$build" --parallel "${SPHK_JOBS:-$(jobs)}" --target "$1" </dev/null >&2 ||
    stop "the build failed; the first error above says where"
}

[[ $# -gt 0 ]] || set -- --help
install_packages
configure
if [[ $1 == test ]]; then
  shift
  build_target all
  exec ctest --test-dir "$build" --output-on-failure --label-exclude "long|readers|arm64" "$@"
fi
build_target sphk
exec "$build/bin/sphk" "$@"
