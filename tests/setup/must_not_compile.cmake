# SPDX-License-Identifier: BSD-3-Clause

# must_not_compile(NAME SAYS): compiling must_not_compile/NAME.cpp fails, with what the regular expression SAYS.
function(must_not_compile name says)
  add_library(must_not_compile_${name} OBJECT EXCLUDE_FROM_ALL must_not_compile/${name}.cpp)
  target_link_libraries(must_not_compile_${name} PRIVATE sphk_kernels fmt::fmt)
  target_compile_options(must_not_compile_${name} PRIVATE -fsyntax-only)
  add_test(NAME must_not_compile_${name}
           COMMAND "${CMAKE_COMMAND}" --build "${PROJECT_BINARY_DIR}" --target must_not_compile_${name})
  set_tests_properties(must_not_compile_${name} PROPERTIES LABELS setup RESOURCE_LOCK build_folder
                                                           PASS_REGULAR_EXPRESSION "${says}")
endfunction()

must_not_compile(order_of_passes "OrderOfPasses<sphk::Rates, sphk::[A-Za-z0-9]+, false>.*Pass reads Field, which no pass")
must_not_compile(pass_that_is_missing
                 "OrderOfPasses<sphk::ConvergenceSwitch, sphk::[A-Za-z]+, false>.*Pass reads Field, which no pass")
must_not_compile(memory_of_passes "MemoryOfPasses<sphk::KickDrift, sphk::[A-Za-z]+, false>.*Pass remembers Field")
must_not_compile(field_of_another_scheme "this scheme has no such field")
must_not_compile(integer_shape "q is a float, a double or a pack of these")
