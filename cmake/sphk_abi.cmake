# SPDX-License-Identifier: BSD-3-Clause

# cmake -DOUT=FILE -DFLAGS=... -P sphk_abi.cmake HEADER... : writes SPHK_ABI, by which sphk knows whether a module was
# compiled against the same headers as itself, with the same compiler and flags that matter to both.
cmake_minimum_required(VERSION 3.24)
set(hashes "${FLAGS}")
file(READ "${HEADERS}" headers)
foreach(header IN LISTS headers)
  file(SHA256 "${header}" hash)
  string(APPEND hashes "${hash}")
endforeach()
string(SHA256 hash "${hashes}")
string(SUBSTRING "${hash}" 0 32 hash)
file(CONFIGURE OUTPUT "${OUT}" CONTENT "#pragma once

/// Of the headers of sphk, the compiler and its options: modules that agree fit.
#define SPHK_ABI \"sphk headers ${hash}\"
")
