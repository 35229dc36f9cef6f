# sphk_test(NAME SOURCES a.cpp... [LIBRARIES target...] [LABELS label...])
# One GoogleTest executable and one ctest of that name. tests/main.cpp starts and ends Kokkos around the tests.

find_package(GTest REQUIRED)

function(sphk_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES;LABELS")
  add_executable(${name} ${arg_SOURCES} "${PROJECT_SOURCE_DIR}/tests/main.cpp")
  target_link_libraries(${name} PRIVATE sphk_kernels ${arg_LIBRARIES} GTest::gtest)
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS "${arg_LABELS}" PROCESSORS 2 ENVIRONMENT "OMP_NUM_THREADS=2")
endfunction()
