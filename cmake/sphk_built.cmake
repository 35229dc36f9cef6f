# SPDX-License-Identifier: BSD-3-Clause
# The libraries of a build folder that is there (SPHK_BUILT), in place of compiling them again.

set(sphk_built_parts engine schemes scenes io report stability)
foreach(part IN LISTS sphk_built_parts ITEMS run)
  add_library(sphk_${part} SHARED IMPORTED GLOBAL)
  set_target_properties(sphk_${part} PROPERTIES IMPORTED_LOCATION "${SPHK_BUILT}/lib/libsphk_${part}.so")
endforeach()
list(TRANSFORM sphk_built_parts PREPEND sphk_)
target_link_libraries(sphk_run INTERFACE ${sphk_built_parts} sphk_kernels fmt::fmt)
