# SPDX-License-Identifier: BSD-3-Clause

# cmake -DBUILD=... -DWORK=... -P modules_on_demand.cmake
# A run compiles the module that it asks for where the build folder lacks it, says so, and the next one finds it.
cmake_minimum_required(VERSION 3.24)

set(module "${BUILD}/lib/sphk/gadget2_1d.so")
function(run_and_expect said)
  execute_process(COMMAND "${BUILD}/bin/sphk" run uniform --scheme gadget2 --steps 1 -n 16 --set scene.dimension=1
                          --overwrite --out "${WORK}"
                  OUTPUT_VARIABLE output ERROR_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
  string(FIND "${output}" "compiling gadget2_1d" place)
  if((said AND place EQUAL -1) OR (NOT said AND NOT place EQUAL -1))
    message(SEND_ERROR "a word of compiling: ${said} is wanted, and the run says\n${output}")
  endif()
  if(NOT EXISTS "${module}")
    message(SEND_ERROR "${module} is not there after a run that takes it")
  endif()
endfunction()

file(REMOVE "${module}")
run_and_expect(YES)
run_and_expect(NO)
