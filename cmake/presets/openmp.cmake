# SPDX-License-Identifier: BSD-3-Clause

# cmake -C cmake/presets/openmp.cmake -B build    OpenMP threads on the processors of this machine; the default.
set(Kokkos_ENABLE_OPENMP ON CACHE BOOL "Kokkos backend: threads by OpenMP")
