# SPDX-License-Identifier: BSD-3-Clause

# Kokkos: one that is installed, else the pinned release, built once and kept in SPHK_CACHE for every build folder.
# Set the backend and the architecture with Kokkos' own options (Kokkos_ENABLE_CUDA, Kokkos_ARCH_HOPPER90, ...).

if(TARGET Kokkos::kokkos)
  return()
endif()
include(sphk_kokkos_archive)
include(sphk_kokkos_build)

set(SPHK_KOKKOS_SOURCE "" CACHE PATH "Folder of a Kokkos source tree to build, instead of the roads")
if(DEFINED ENV{XDG_CACHE_HOME})
  set(SPHK_CACHE "$ENV{XDG_CACHE_HOME}/sphk" CACHE PATH "Where downloads and the built Kokkos are kept")
else()
  set(SPHK_CACHE "$ENV{HOME}/.cache/sphk" CACHE PATH "Where downloads and the built Kokkos are kept")
endif()

set(sphk_backends SERIAL OPENMP THREADS CUDA HIP SYCL)
set(sphk_wanted_backends "")
foreach(backend IN LISTS sphk_backends)
  if(Kokkos_ENABLE_${backend})
    list(APPEND sphk_wanted_backends ${backend})
  endif()
endforeach()
if(NOT sphk_wanted_backends)
  set(Kokkos_ENABLE_OPENMP ON CACHE BOOL "Kokkos backend: threads by OpenMP")
  set(sphk_wanted_backends OPENMP)
endif()

# The installed one must have the wanted backends and no parallel one besides, which Kokkos would run instead.
function(sphk_check_installed_kokkos)
  set(surplus ${Kokkos_DEVICES})
  list(REMOVE_ITEM surplus SERIAL ${sphk_wanted_backends})
  set(missing ${sphk_wanted_backends})
  list(REMOVE_ITEM missing ${Kokkos_DEVICES})
  if(surplus OR missing)
    message(FATAL_ERROR
      "sphk: the Kokkos ${Kokkos_VERSION} in ${Kokkos_DIR} was built for ${Kokkos_DEVICES}, this build asks for "
      "${sphk_wanted_backends}. Pass -DSPHK_KOKKOS_ROADS=\"github;pypi\" to have the right one built, or "
      "-DKokkos_ROOT=PREFIX with one built for ${sphk_wanted_backends}.")
  endif()
endfunction()

if("installed" IN_LIST SPHK_KOKKOS_ROADS AND NOT SPHK_KOKKOS_SOURCE)
  find_package(Kokkos 4.7 QUIET CONFIG)
  if(Kokkos_FOUND)
    sphk_check_installed_kokkos()
    set(sphk_kokkos_folder "${Kokkos_DIR}")
    message(STATUS "sphk: Kokkos ${Kokkos_VERSION} is installed in ${Kokkos_DIR}")
    get_target_property(kind Kokkos::kokkoscore TYPE)
    if(SPHK_MODULES AND kind STREQUAL "STATIC_LIBRARY")
      set(SPHK_MODULES OFF)
      message(STATUS "sphk: it is a static library, so all schemes are linked into each program")
    endif()
    return()
  endif()
  message(STATUS "sphk: Kokkos 4.7 is not installed")
endif()

sphk_kokkos_build(sphk_kokkos_prefix)
unset(Kokkos_DIR CACHE)
find_package(Kokkos 4.7 REQUIRED CONFIG NO_DEFAULT_PATH PATHS "${sphk_kokkos_prefix}")
set(sphk_kokkos_folder "${Kokkos_DIR}")
unset(Kokkos_DIR CACHE)  # else the next configuration would take it for an installed one and not look at its recipe
