# SPDX-License-Identifier: BSD-3-Clause

# sphk::sphk, the whole library under one name, and its installation: find_package(sphk) gives the same name. Headers go
# to include/sphk/{kernels,src}, so that an #include reads the same in this tree and outside it.

add_library(sphk_library INTERFACE)
add_library(sphk::sphk ALIAS sphk_library)
set_target_properties(sphk_library PROPERTIES EXPORT_NAME sphk)
target_include_directories(sphk_library INTERFACE "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src/include>"
                                                  "$<INSTALL_INTERFACE:include/sphk>")

set(sphk_exported sphk_library sphk_kernels)
foreach(part engine schemes scenes io report stability run)
  if(TARGET sphk_${part})
    target_link_libraries(sphk_library INTERFACE sphk_${part})
    set_target_properties(sphk_${part} PROPERTIES EXPORT_NAME ${part})
    list(APPEND sphk_exported sphk_${part})
  endif()
endforeach()
set_target_properties(sphk_kernels PROPERTIES EXPORT_NAME kernels)
# Runs and loops that a scheme of one's own may share with those of the list.
target_link_libraries(sphk_library INTERFACE sphk_loops sphk_abi)
get_property(module_libraries GLOBAL PROPERTY sphk_module_libraries)
list(APPEND sphk_exported sphk_loops sphk_engines sphk_abi)

if(NOT SPHK_INSTALL)
  return()
endif()
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(sphk_config_folder "${CMAKE_INSTALL_LIBDIR}/cmake/sphk")
install(TARGETS ${sphk_exported} EXPORT sphk_targets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
        LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}")
if(SPHK_MODULES)
  install(TARGETS ${module_libraries} EXPORT sphk_targets LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/sphk")
  install(TARGETS sphk_command sphk_study sphk_tables LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}")
endif()
install(FILES "${PROJECT_BINARY_DIR}/include/sphk_abi.hpp" DESTINATION include/sphk)
# Its own Kokkos comes along, so that the installation may be moved.
if(SPHK_MODULES AND sphk_kokkos_prefix)
  install(DIRECTORY "${sphk_kokkos_prefix}/lib/" DESTINATION "${CMAKE_INSTALL_LIBDIR}"
          FILES_MATCHING PATTERN "libkokkos*.so*" PATTERN cmake EXCLUDE)
endif()
install(EXPORT sphk_targets NAMESPACE sphk:: FILE sphkTargets.cmake DESTINATION "${sphk_config_folder}")
install(DIRECTORY kernels src DESTINATION include/sphk FILES_MATCHING PATTERN "*.hpp" PATTERN include EXCLUDE)
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/sphk")
install(DIRECTORY src/include/ DESTINATION include/sphk)
configure_package_config_file(cmake/sphkConfig.cmake.in "${PROJECT_BINARY_DIR}/sphkConfig.cmake"
                              INSTALL_DESTINATION "${sphk_config_folder}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/sphkConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/sphkConfig.cmake" "${PROJECT_BINARY_DIR}/sphkConfigVersion.cmake"
        DESTINATION "${sphk_config_folder}")
