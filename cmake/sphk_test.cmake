# sphk_test(NAME SOURCES a.cpp... [LIBRARIES target...] [LABELS label...])
# One GoogleTest executable and one ctest of that name. tests/main.cpp starts and ends Kokkos around the tests.

find_package(GTest REQUIRED)

# Parsing Kokkos and GoogleTest takes 3 of the 5 s that a test compiles, so they are precompiled, once. A source file
# of kernels/ is compiled with nvcc_wrapper where CUDA is on, and nvcc reads no precompiled header.
if(Kokkos_ENABLE_CUDA)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()
add_library(sphk_test_main OBJECT "${PROJECT_SOURCE_DIR}/tests/main.cpp")
target_link_libraries(sphk_test_main PUBLIC sphk_kernels GTest::gtest)
target_precompile_headers(sphk_test_main PRIVATE <Kokkos_Core.hpp> <gtest/gtest.h>)

function(sphk_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES;LABELS")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE sphk_test_main ${arg_LIBRARIES})
  target_precompile_headers(${name} REUSE_FROM sphk_test_main)
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS "${arg_LABELS}" PROCESSORS 2 ENVIRONMENT "OMP_NUM_THREADS=2")
endfunction()
