# SPDX-License-Identifier: BSD-3-Clause

# How sphk is compiled: build type, C++ standard, warnings, contraction of a*b+c to one fused operation.

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug, RelWithDebInfo or MinSizeRel" FORCE)
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

# GPU code is one program, and device functions are not called across shared objects.
if(Kokkos_ENABLE_CUDA OR Kokkos_ENABLE_HIP)
  set(SPHK_MODULES OFF)
endif()
if(SPHK_MODULES)
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
  set(CMAKE_BUILD_RPATH_USE_ORIGIN ON)  # bin, lib and share of a build folder may be taken elsewhere together
  set(CMAKE_INSTALL_RPATH "$ORIGIN;$ORIGIN/../lib")
  set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)
  # A function that is called where it is defined may be inlined there, as in a static library.
  add_compile_options("$<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-semantic-interposition>")
endif()

# Warnings of sphk's own code; a project that adds this folder has its own. Left out are three that g++ 12 raises of
# std::string and of packs in registers, where nothing is wrong, and that of members which designated initialisers leave
# at their defaults.
if(PROJECT_IS_TOP_LEVEL AND NOT Kokkos_ENABLE_CUDA)
  add_compile_options("$<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang>:-Wall;-Wextra;-Wshadow;-Wconversion;-Wno-missing-field-initializers>"
                      "$<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-restrict;-Wno-stringop-overread;-Wno-stringop-overflow>")
endif()
