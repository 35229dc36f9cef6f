# SPDX-License-Identifier: BSD-3-Clause

# cmake -C cmake/presets/serial.cmake -B build/serial    One thread, no OpenMP.
set(Kokkos_ENABLE_SERIAL ON CACHE BOOL "Kokkos backend: one thread")
