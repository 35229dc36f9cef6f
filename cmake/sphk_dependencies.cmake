# SPDX-License-Identifier: BSD-3-Clause

# Host libraries, all packaged by Debian: HDF5, fmt, toml11, CLI11, nlohmann-json, Eigen.

find_package(HDF5 REQUIRED COMPONENTS C)
find_package(fmt REQUIRED)
find_package(toml11 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Eigen3 REQUIRED)

# fmt 9 takes nvcc for a compiler without constexpr, and then fails its own consteval check of format strings.
if(Kokkos_ENABLE_CUDA)
  set_property(TARGET fmt::fmt APPEND PROPERTY INTERFACE_COMPILE_DEFINITIONS FMT_USE_CONSTEXPR=1)
endif()
