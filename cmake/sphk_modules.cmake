# SPDX-License-Identifier: BSD-3-Clause

# Schemes as shared objects: lib/sphk/NAME_Dd.so beside the libraries, loaded when asked for. What is not built
# is compiled when a run asks for it, in the build folder alone; `sphk_modules` builds all.

include(GNUInstallDirs)
set(sphk_library_folder "${PROJECT_BINARY_DIR}/lib")
set(sphk_module_folder "${sphk_library_folder}/sphk")

# sphk_abi: SPHK_ABI, a hash of the headers that modules see, the compiler and its options.
file(GLOB_RECURSE headers CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/kernels/*.hpp" "${PROJECT_SOURCE_DIR}/src/engine/*.hpp"
     "${PROJECT_SOURCE_DIR}/src/schemes/*.hpp" "${PROJECT_SOURCE_DIR}/src/scenes/*.hpp")
file(WRITE "${PROJECT_BINARY_DIR}/abi_headers.txt.new" "${headers}")
file(COPY_FILE "${PROJECT_BINARY_DIR}/abi_headers.txt.new" "${PROJECT_BINARY_DIR}/abi_headers.txt" ONLY_IF_DIFFERENT)
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
set(abi_header "${PROJECT_BINARY_DIR}/include/sphk_abi.hpp")
add_custom_command(OUTPUT "${abi_header}"
                   COMMAND "${CMAKE_COMMAND}" "-DOUT=${abi_header}" "-DHEADERS=${PROJECT_BINARY_DIR}/abi_headers.txt"
                           "-DFLAGS=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}}"
                           -P "${PROJECT_SOURCE_DIR}/cmake/sphk_abi.cmake"
                   DEPENDS ${headers} "${PROJECT_BINARY_DIR}/abi_headers.txt" "${PROJECT_SOURCE_DIR}/cmake/sphk_abi.cmake" VERBATIM)
add_custom_target(sphk_abi_header DEPENDS "${abi_header}")
add_library(sphk_abi INTERFACE)
target_include_directories(sphk_abi INTERFACE "$<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>")
add_dependencies(sphk_abi sphk_abi_header)

add_custom_target(sphk_modules ALL)  # every scheme, where they are shared objects
if(NOT SPHK_MODULES)
  return()
endif()

add_library(sphk_module_abi OBJECT "${PROJECT_SOURCE_DIR}/cmake/sphk_module_abi.cpp")
target_link_libraries(sphk_module_abi PRIVATE sphk_abi)

# Where they lie, here and installed; how they find the libraries there.
function(sphk_is_module target)
  set_target_properties(${target} PROPERTIES DEFINE_SYMBOL "" EXCLUDE_FROM_ALL ON LIBRARY_OUTPUT_DIRECTORY "${sphk_module_folder}"
                        INSTALL_RPATH "$ORIGIN;$ORIGIN/..")
  target_link_options(${target} PRIVATE $<$<PLATFORM_ID:Linux>:-Wl,-z,defs>)
  add_dependencies(sphk_modules ${target})
endfunction()

# A library of loops that schemes share.
function(sphk_loops_library name sources)
  add_library(sphk_loops_${name} SHARED ${sources})
  set_property(GLOBAL APPEND PROPERTY sphk_module_libraries sphk_loops_${name})
  target_link_libraries(sphk_loops_${name} PRIVATE sphk_engine sphk_schemes)
  target_link_libraries(sphk_loops INTERFACE sphk_loops_${name})
  precompile(sphk_loops_${name})
  sphk_is_module(sphk_loops_${name})
endfunction()

function(sphk_scheme_module name sources loops)
  add_library(${name} MODULE ${sources} $<TARGET_OBJECTS:sphk_module_abi>)
  set_target_properties(${name} PROPERTIES PREFIX "")
  if(SPHK_INSTALL)
    install(TARGETS ${name} LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/sphk")
  endif()
  target_link_libraries(${name} PRIVATE sphk_engine sphk_schemes ${loops})
  precompile(${name})
  sphk_is_module(${name})
endfunction()

# The program reads there how it gets a module that is missing or of older headers.
function(sphk_modules_are_built_on_demand)
  file(WRITE "${sphk_module_folder}/build_command.txt"
       "'${CMAKE_COMMAND}' --build '${PROJECT_BINARY_DIR}' --parallel --target\n")
endfunction()
