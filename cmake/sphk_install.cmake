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

if(NOT SPHK_INSTALL)
  return()
endif()
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(sphk_config_folder "${CMAKE_INSTALL_LIBDIR}/cmake/sphk")
install(TARGETS ${sphk_exported} EXPORT sphk_targets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(EXPORT sphk_targets NAMESPACE sphk:: FILE sphkTargets.cmake DESTINATION "${sphk_config_folder}")
install(DIRECTORY kernels src DESTINATION include/sphk FILES_MATCHING PATTERN "*.hpp" PATTERN include EXCLUDE)
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/sphk")
install(DIRECTORY src/include/ DESTINATION include/sphk)
configure_package_config_file(cmake/sphkConfig.cmake.in "${PROJECT_BINARY_DIR}/sphkConfig.cmake"
                              INSTALL_DESTINATION "${sphk_config_folder}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/sphkConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/sphkConfig.cmake" "${PROJECT_BINARY_DIR}/sphkConfigVersion.cmake"
        DESTINATION "${sphk_config_folder}")
