# cmake -DSOURCE=... -DWORK=... -P include_rules_catch.cmake
# include_rules.cmake catches each kind of offence and lets the rest pass.
cmake_minimum_required(VERSION 3.24)

function(check folder line expected)
  file(REMOVE_RECURSE "${WORK}")
  file(WRITE "${WORK}/kernels/${folder}/probe.hpp" "#pragma once\n${line}\n")
  execute_process(COMMAND "${CMAKE_COMMAND}" "-DSOURCE=${WORK}" -P "${SOURCE}/tests/setup/include_rules.cmake"
                  RESULT_VARIABLE code OUTPUT_QUIET ERROR_QUIET)
  if((expected STREQUAL "pass" AND NOT code EQUAL 0) OR (expected STREQUAL "fail" AND code EQUAL 0))
    message(SEND_ERROR "kernels/${folder} with ${line}: expected to ${expected}, exit code ${code}")
  endif()
endfunction()

check(core "#include <type_traits>" pass)
check(core "#include <Kokkos_SIMD.hpp>" pass)
check(terms "#include \"kernels/core/vec.hpp\"  // Vec" pass)
check(passes "#include \"kernels/cells/tiles.hpp\"" pass)
check(core "#include <iostream>" fail)
check(core "#include <hdf5.h>" fail)
check(core "#include <Eigen/Dense>" fail)
check(core "  #  include <immintrin.h>" fail)
check(core "#include \"src/engine/settings.hpp\"" fail)
check(core "#include \"vec.hpp\"" fail)
check(core "#include \"kernels/terms/viscosity.hpp\"" fail)
check(terms "#include \"kernels/passes/rates.hpp\"" fail)
check(smoothing "#include <../iostream>" fail)
