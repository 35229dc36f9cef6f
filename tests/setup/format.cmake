# SPDX-License-Identifier: BSD-3-Clause

# cmake -DSOURCE=... -DFORMAT=clang-format -P format.cmake
# Every source file is as .clang-format has it.
cmake_minimum_required(VERSION 3.24)

set(files "")
foreach(folder kernels src tests bench)
  file(GLOB_RECURSE some "${SOURCE}/${folder}/*.hpp" "${SOURCE}/${folder}/*.cpp")
  list(APPEND files ${some})
endforeach()
execute_process(COMMAND "${FORMAT}" --dry-run -Werror ${files} RESULT_VARIABLE code ERROR_VARIABLE output)
if(NOT code EQUAL 0)
  string(REGEX MATCHALL "[^\n]*error: code should be clang-formatted" places "${output}")
  list(JOIN places "\n" places)
  message(FATAL_ERROR "clang-format -i mends these:\n${places}")
endif()
