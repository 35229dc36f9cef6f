# SPDX-License-Identifier: BSD-3-Clause

# cmake -C cmake/presets/cuda.cmake -B build/cuda    NVIDIA GPUs; nvcc has to be on the PATH. Another GPU than Hopper:
# add -DKokkos_ARCH_HOPPER90=OFF -DKokkos_ARCH_AMPERE80=ON (the names are Kokkos' own).
set(Kokkos_ENABLE_CUDA ON CACHE BOOL "Kokkos backend: CUDA")
set(Kokkos_ENABLE_CUDA_CONSTEXPR ON CACHE BOOL "constexpr functions of the standard library may be called on the GPU")
set(Kokkos_ARCH_HOPPER90 ON CACHE BOOL "GPU architecture")
