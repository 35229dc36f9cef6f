# cmake -DROAD=installed|folder -DSOURCE=... -DBUILD=... -DWORK=... -DGENERATOR=...
#       -DKOKKOS=... -DSETTINGS=FILE "-DTARGETS=a b" -P consumer.cmake
# Builds docs/examples against sphk, installed from the build folder or added as a folder, and runs it.
# SETTINGS is an initial cache, as a preset is.
cmake_minimum_required(VERSION 3.24)

separate_arguments(TARGETS)
file(REMOVE_RECURSE "${WORK}/prefix")
if(ROAD STREQUAL "installed")
  execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/prefix"
                  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  set(options "-DCMAKE_PREFIX_PATH=${WORK}/prefix")
else()
  set(options "-DSPHK_FOLDER=${SOURCE}" "-DKokkos_ROOT=${KOKKOS}")
endif()
execute_process(COMMAND "${CMAKE_COMMAND}" -G "${GENERATOR}" -C "${SETTINGS}" ${options}
                        -S "${SOURCE}/docs/examples" -B "${WORK}/build"
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${WORK}/build" --target ${TARGETS} COMMAND_ERROR_IS_FATAL ANY)
foreach(target IN LISTS TARGETS)
  execute_process(COMMAND "${WORK}/build/${target}" COMMAND_ERROR_IS_FATAL ANY)
endforeach()
