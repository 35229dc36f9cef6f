# SPDX-License-Identifier: BSD-3-Clause

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

# A shared object with a scheme, a smoothing kernel and a scene, loaded by the installed command.
if(MODULES)
  execute_process(COMMAND "${CMAKE_COMMAND}" --build "${WORK}/build" --target own_module COMMAND_ERROR_IS_FATAL ANY)
  set(sphk "${WORK}/prefix/bin/sphk")
  set(module "${WORK}/build/libown_module.so")
  # expect(WORDS COMMAND...): the command ends well, and says these words.
  function(expect words)
    execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE said ERROR_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
    string(FIND "${said}" "${words}" place)
    if(place EQUAL -1)
      message(SEND_ERROR "${ARGN} does not say \"${words}\":\n${said}")
    endif()
  endfunction()
  expect("SPH with friction" "${sphk}" list --module "${module}")
  expect("scheme rubbing, kernel cubed" "${sphk}" run standing-wave --scheme rubbing --steps 3 --module "${module}"
         --set friction.k=2 --overwrite --out "${WORK}/rubbing")
  execute_process(COMMAND "${sphk}" run uniform --set scene.dimension=2 -n 16 --scheme rubbing --module "${module}"
                  ERROR_VARIABLE said RESULT_VARIABLE code OUTPUT_QUIET)
  if(NOT code EQUAL 2 OR NOT said MATCHES "the scheme rubbing is not made for 2D")
    message(SEND_ERROR "a scheme in a dimension that it is not made for: exit code ${code}, ${said}")
  endif()
  # Under any scheme the kernel runs through the table; by the environment as well.
  set(ENV{SPHK_MODULE_PATH} "${module}")
  expect("scheme gadget2, kernel cubed" "${sphk}" run uniform --scheme gadget2 --kernel cubed --steps 1 -n 16
         --set scene.dimension=1 --overwrite --out "${WORK}/cubed")
  execute_process(COMMAND "${sphk}" list --module "${sphk}" ERROR_VARIABLE said RESULT_VARIABLE code OUTPUT_QUIET)
  if(NOT code EQUAL 2 OR NOT said MATCHES "was not compiled against this sphk")
    message(SEND_ERROR "a file that is no module: exit code ${code}, ${said}")
  endif()
endif()
