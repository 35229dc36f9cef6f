# SPDX-License-Identifier: BSD-3-Clause

# sphk_kernels: the device code, header-only. Everything else links it, directly or not.

add_library(sphk_kernels INTERFACE)
add_library(sphk::kernels ALIAS sphk_kernels)
target_include_directories(sphk_kernels INTERFACE "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>"
                                                  "$<INSTALL_INTERFACE:include/sphk>")
target_compile_features(sphk_kernels INTERFACE cxx_std_20)
# a*b + c in one rounding: allowed in every expression, which is what the compilers do by themselves in GNU mode.
target_compile_options(sphk_kernels INTERFACE $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang>:-ffp-contract=fast>)
target_link_libraries(sphk_kernels INTERFACE Kokkos::kokkos)

# sphk_add_subdirectories(NAME...): the sub-folders of this folder that hold a CMakeLists.txt.
function(sphk_add_subdirectories)
  foreach(folder IN LISTS ARGV)
    if(EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/CMakeLists.txt")
      add_subdirectory(${folder})
    endif()
  endforeach()
endfunction()
