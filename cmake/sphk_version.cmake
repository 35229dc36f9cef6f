# SPDX-License-Identifier: BSD-3-Clause

# sphk_version: gives `#include <sphk_version.hpp>`. Written again when a commit or a checkout moves HEAD, without a
# new configuration. Run as a script (cmake -P) it fills in the git revision, else it makes the target.

if(CMAKE_SCRIPT_MODE_FILE)
  execute_process(COMMAND git -C "${SOURCE}" rev-parse --short=12 HEAD
                  OUTPUT_VARIABLE SPHK_GIT_REVISION OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT SPHK_GIT_REVISION)
    set(SPHK_GIT_REVISION unknown)
  endif()
  configure_file("${INPUT}" "${OUTPUT}" @ONLY)
  file(TOUCH_NOCREATE "${OUTPUT}")
  return()
endif()

set(SPHK_GIT_REVISION "@SPHK_GIT_REVISION@")  # stays a placeholder for the script
configure_file("${PROJECT_SOURCE_DIR}/cmake/sphk_version.hpp.in" "${PROJECT_BINARY_DIR}/sphk_version.hpp.in" @ONLY)
execute_process(COMMAND git -C "${PROJECT_SOURCE_DIR}" rev-parse --path-format=absolute --git-path logs/HEAD
                OUTPUT_VARIABLE sphk_git_log OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT EXISTS "${sphk_git_log}")
  set(sphk_git_log "")
endif()

set(sphk_version_header "${PROJECT_BINARY_DIR}/include/sphk_version.hpp")
add_custom_command(
  OUTPUT "${sphk_version_header}"
  COMMAND "${CMAKE_COMMAND}" "-DSOURCE=${PROJECT_SOURCE_DIR}" "-DINPUT=${PROJECT_BINARY_DIR}/sphk_version.hpp.in"
          "-DOUTPUT=${sphk_version_header}" -P "${CMAKE_CURRENT_LIST_FILE}"
  DEPENDS "${PROJECT_BINARY_DIR}/sphk_version.hpp.in" ${sphk_git_log}
  COMMENT "Writing sphk_version.hpp" VERBATIM)
add_custom_target(sphk_version_header DEPENDS "${sphk_version_header}")
add_library(sphk_version INTERFACE)
add_dependencies(sphk_version sphk_version_header)
target_include_directories(sphk_version INTERFACE "$<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>")
