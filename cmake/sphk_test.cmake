# SPDX-License-Identifier: BSD-3-Clause

# sphk_test(NAME SOURCES a.cpp... [LIBRARIES target...] [LABELS label...])
# One GoogleTest executable and one ctest of that name. tests/main.cpp starts and ends Kokkos around the tests.

find_package(GTest REQUIRED)

# Parsing Kokkos and GoogleTest takes 3 of the 5 s that a test compiles, so they are precompiled. Tests that compile loops
# over particles are optimised like these; for the others a third of the time to compile would be lost to it, and half of
# it to headers, which six of them parse together. A source file of kernels/ is compiled with nvcc_wrapper where CUDA is
# on, and nvcc reads no precompiled header.
if(Kokkos_ENABLE_CUDA)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()
foreach(main sphk_test_main sphk_test_main_quick)
  add_library(${main} OBJECT "${PROJECT_SOURCE_DIR}/tests/main.cpp")
  target_link_libraries(${main} PUBLIC sphk_kernels GTest::gtest)
  target_precompile_headers(${main} PRIVATE <Kokkos_Core.hpp> <gtest/gtest.h>)
endforeach()
target_compile_options(sphk_test_main_quick PUBLIC -O1)

function(sphk_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES;LABELS")
  cmake_path(GET CMAKE_CURRENT_SOURCE_DIR FILENAME room)
  set(main sphk_test_main)
  set(unity OFF)
  if(NOT room MATCHES "^(core|smoothing|cells|terms|passes|engine)$")
    string(APPEND main _quick)
    set(unity ON)
  endif()
  add_executable(${name} ${arg_SOURCES})
  set_target_properties(${name} PROPERTIES UNITY_BUILD "${unity}" UNITY_BUILD_BATCH_SIZE 6)
  target_link_libraries(${name} PRIVATE ${main} ${arg_LIBRARIES})
  target_precompile_headers(${name} REUSE_FROM ${main})
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS "${arg_LABELS}" PROCESSORS 2 ENVIRONMENT "OMP_NUM_THREADS=2")
endfunction()
