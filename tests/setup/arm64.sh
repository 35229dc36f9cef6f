#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause

# arm64.sh SOURCE WORK SPHK [CMAKE_OPTION...]
# sphk for 64-bit ARM, which computes in packs of NEON, by cmake/aarch64-linux-gnu.cmake: the tests of packs, cells, terms and
# passes run under qemu-user, and every scheme gives what SPHK, this machine's own program, gives of the same gas: one
# right-hand side, to 1e-10 in double and 1e-5 in mixed arithmetic, and three steps. The libraries come from SPHK_SYSROOT or,
# on Debian, into WORK/sysroot. Compiles all schemes: SCHEMES="gadget2 sphs" takes these alone.
set -euo pipefail
source=$1 work=$2 native=$3
shift 3
export OMP_NUM_THREADS=2

skip() { echo "skipped: $*"; exit 77; }
qemu=$(command -v qemu-aarch64 || command -v qemu-aarch64-static) || skip "needs qemu-aarch64; install qemu-user"
command -v aarch64-linux-gnu-g++ >/dev/null || skip "needs a compiler for 64-bit ARM; install g++-aarch64-linux-gnu"
python=python3
"$python" -c "import h5py" 2>/dev/null || python=/usr/bin/python3
"$python" -c "import h5py" 2>/dev/null || skip "needs Python's h5py; install python3-h5py"

packages=(libhdf5-dev libfmt-dev libcli11-dev libtoml11-dev nlohmann-json3-dev libeigen3-dev libgtest-dev libgomp1)
mkdir -p "$work"
if [[ -z ${SPHK_SYSROOT:-} ]]; then
  export SPHK_SYSROOT="$work/sysroot"
  if [[ ! -e $SPHK_SYSROOT.complete ]]; then
    command -v mmdebstrap >/dev/null || skip "needs the libraries for arm64 in a folder, SPHK_SYSROOT; install mmdebstrap to get them"
    rm -rf "$SPHK_SYSROOT"
    mmdebstrap --quiet --mode=chrootless --variant=extract --architectures=arm64 \
      --include="$(IFS=,; echo "${packages[*]}")" bookworm "$SPHK_SYSROOT"
    # Links to a place on the machine that the libraries are for, led to that place in the folder.
    find "$SPHK_SYSROOT"/{lib,usr} -lname '/*' | while read -r link; do
      ln -sfr "$SPHK_SYSROOT$(readlink "$link")" "$link"
    done
    touch "$SPHK_SYSROOT.complete"
  fi
fi

mapfile -t schemes < <("$native" list | sed -n '/^scheme /,/^$/s/^\([a-z0-9-]*\)  .*/\1/p' | sed 1d)
[[ -z ${SCHEMES:-} ]] || read -ra schemes <<<"$SCHEMES"
only=${SCHEMES:-}
only=${only//-/_}

build="$work/build"
cmake --toolchain "$source/cmake/aarch64-linux-gnu.cmake" -S "$source" -B "$build" -DSPHK_BENCH=OFF \
  "-DSPHK_SCHEMES=${only// /;}" "$@"
cmake --build "$build" --parallel "${SPHK_JOBS:-2}" --target core cells terms passes sphk sphk_modules
ctest --test-dir "$build" --output-on-failure --no-tests=error --tests-regex '^(core|cells|terms|passes)$'

same() { "$python" "$source/tests/setup/same_fields.py" "$@"; }
emulated=("$qemu" -L "$SPHK_SYSROOT" "$build/bin/sphk")
cd "$work"
"$native" run sod -n 4 --scheme sph --steps 2 --out start --overwrite >/dev/null
for scheme in "${schemes[@]}"; do
  echo "$scheme"
  for tolerance in double,1e-10 mixed,1e-5; do
    as=(start/snap_0002.hdf5 --scheme "$scheme" --precision "${tolerance%,*}")
    "$native" rates "${as[@]}" --out native.hdf5 >/dev/null
    "${emulated[@]}" rates "${as[@]}" --out emulated.hdf5 >/dev/null
    same "${tolerance#*,}" native.hdf5 emulated.hdf5 Density Acceleration
  done
  as=(start/snap_0002.hdf5 --scheme "$scheme" --t-end 1 --steps 3 --overwrite)
  "$native" run "${as[@]}" --out native >/dev/null
  "${emulated[@]}" run "${as[@]}" --out emulated >/dev/null
  same 1e-5 native/snap_0001.hdf5 emulated/snap_0001.hdf5 Coordinates Velocities Density
done
