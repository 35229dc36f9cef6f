#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause

# tidy.sh SOURCE BUILD CLANG_TIDY: clang-tidy, as .clang-tidy has it, on the host code that the newest commits changed,
# with the compiler options of the build. All of src takes an hour: TIDY=all does that.
set -euo pipefail
source=$1 build=$2 tidy=$3
cd "$source"
git rev-parse HEAD >/dev/null 2>&1 || { echo "no git history to tell what changed"; exit 77; }
host='^src/(io|report|run|study|scenes|stability|tables|cli|schemes/re|engine/[a-z_]*s)[a-z_/]*\.cpp$'
if [[ ${TIDY:-} == all ]]; then
  mapfile -t files < <(git ls-files src | grep -E "$host")
else
  mapfile -t files < <(git log -n 5 --name-only --format= --diff-filter=d -- src | grep -E "$host" | sort -u | head -n 3)
fi
[[ ${#files[@]} -gt 0 ]] || { echo "the newest commits changed no host code"; exit 0; }
includes=$(grep -ohE -- '-isystem [^ ]+' "$build/build.ninja" 2>/dev/null | sort -u | xargs)
# shellcheck disable=SC2086  # one word an option
"$tidy" --quiet --warnings-as-errors='*' "${files[@]}" -- -std=c++20 -fopenmp -march=native -I"$source" -I"$build/include" $includes
