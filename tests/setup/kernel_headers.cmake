# SPDX-License-Identifier: BSD-3-Clause

# Each header of kernels/ compiles on its own: one source file a header, which includes it and nothing else. Kokkos,
# 3 s to parse, is precompiled, and given only to headers that include it, so that none can forget to.

# Whether a header includes Kokkos, itself or through another header of kernels/.
function(sphk_includes_kokkos out header)
  get_property(known GLOBAL PROPERTY "sphk_kokkos_in_${header}")
  if("${known}" STREQUAL "" AND EXISTS "${PROJECT_SOURCE_DIR}/${header}")
    set(known NO)
    set_property(GLOBAL PROPERTY "sphk_kokkos_in_${header}" ${known})
    file(STRINGS "${PROJECT_SOURCE_DIR}/${header}" includes REGEX "^#include")
    foreach(line IN LISTS includes)
      set(inner NO)
      if(line MATCHES "\"(.*)\"")
        sphk_includes_kokkos(inner "${CMAKE_MATCH_1}")
      endif()
      if(inner OR line MATCHES "<Kokkos_")
        set(known YES)
      endif()
    endforeach()
    set_property(GLOBAL PROPERTY "sphk_kokkos_in_${header}" ${known})
  endif()
  set(${out} ${known} PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}" "${PROJECT_SOURCE_DIR}/kernels/*.hpp")
add_library(kernel_headers OBJECT)
target_link_libraries(kernel_headers PRIVATE sphk_kernels)
target_precompile_headers(kernel_headers PRIVATE <Kokkos_Core.hpp>)
foreach(header IN LISTS headers)
  string(REPLACE ".hpp" ".cpp" source "${CMAKE_CURRENT_BINARY_DIR}/headers/${header}")
  file(CONFIGURE OUTPUT "${source}" CONTENT "#include \"${header}\"\n")
  target_sources(kernel_headers PRIVATE "${source}")
  sphk_includes_kokkos(with_kokkos "${header}")
  if(NOT with_kokkos)
    set_source_files_properties("${source}" PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  endif()
endforeach()
