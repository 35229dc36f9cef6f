# SPDX-License-Identifier: BSD-3-Clause

# cmake -C cmake/presets/debug.cmake -B build/debug    AddressSanitizer, UndefinedBehaviorSanitizer and View bounds checks.
# The checks that are left out take three quarters of the compile time and half of the tests' time; what most of them
# find, the others find as well: a null or stray pointer is caught when it is followed. Not caught is the use of a local
# after its block. -g1 gives a report its files and lines.
set(CMAKE_BUILD_TYPE Debug CACHE STRING "Build type")
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g1 -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all \
-fno-sanitize=null,alignment,object-size,pointer-overflow,vptr -fno-sanitize-address-use-after-scope"
    CACHE STRING "Compiler options of a debug build")
set(SPHK_SANITIZER address CACHE STRING "Sanitizer of this build")
set(Kokkos_ENABLE_OPENMP ON CACHE BOOL "Kokkos backend: threads by OpenMP")
set(Kokkos_ENABLE_DEBUG_BOUNDS_CHECK ON CACHE BOOL "Every View access is checked")
