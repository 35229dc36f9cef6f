# SPDX-License-Identifier: BSD-3-Clause

# cmake -DSOURCE=... -DWORK=... -DGENERATOR=... -DSETTINGS=FILE -DKOKKOS=... -P adding.cmake
# Adds a smoothing kernel, a field, a term with a number, a pass, a scheme and a scene to a copy of the tree, each a file
# and its line, builds and runs: the command line knows them, and so do pictures, snapshots and lists.
cmake_minimum_required(VERSION 3.24)

set(tree "${WORK}/tree")
file(REMOVE_RECURSE "${tree}")
foreach(part CMakeLists.txt LICENSE README.md cmake kernels src docs)
  file(COPY "${SOURCE}/${part}" DESTINATION "${tree}")
endforeach()

# replace(FILE OLD NEW): one line of a file of the copy.
function(replace file old new)
  file(READ "${tree}/${file}" text)
  string(FIND "${text}" "${old}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "${file} has no \"${old}\": the place where things are added has moved")
  endif()
  string(REPLACE "${old}" "${new}" text "${text}")
  file(WRITE "${tree}/${file}" "${text}")
endfunction()

# The examples' own definitions, as files of the tree.
file(READ "${SOURCE}/docs/examples/own_scheme.hpp" example)
function(cut result from to)
  string(FIND "${example}" "${from}" begin)
  string(FIND "${example}" "${to}" end)
  if("${to}" STREQUAL "")
    string(LENGTH "${example}" end)
  endif()
  if(begin EQUAL -1 OR end LESS begin)
    message(FATAL_ERROR "own_scheme.hpp has no part from \"${from}\" to \"${to}\"")
  endif()
  math(EXPR length "${end} - ${begin}")
  string(SUBSTRING "${example}" ${begin} ${length} part)
  set(${result} "${part}" PARENT_SCOPE)
endfunction()
cut(kernel "/// w(q) = (1-q)^3." "/// A field that")
cut(term "/// A field that" "/// SPH with friction")
cut(scene "/// A standing wave" "")

file(WRITE "${tree}/kernels/smoothing/cubed.hpp" "#pragma once
#include \"kernels/smoothing/norm.hpp\"
#include \"kernels/smoothing/power.hpp\"
namespace sphk {
${kernel}}
")
replace(kernels/smoothing/cubed.hpp "  KOKKOS_INLINE_FUNCTION constexpr double norm"
        "  template <class T> KOKKOS_INLINE_FUNCTION T w(T q) const { return (*this)(q).w; }
  KOKKOS_INLINE_FUNCTION constexpr double norm")
replace(kernels/smoothing/list.hpp "BSpline<6>, WendlandC2" "BSpline<6>, Cubed, WendlandC2")
replace(kernels/smoothing/list.hpp "#include \"kernels/smoothing/hoct.hpp\""
        "#include \"kernels/smoothing/cubed.hpp\"\n#include \"kernels/smoothing/hoct.hpp\"")

file(WRITE "${tree}/kernels/terms/friction.hpp" "#pragma once
#include \"kernels/smoothing/pair.hpp\"
#include \"kernels/terms/term_set.hpp\"
namespace sphk {
${term}}
")

file(WRITE "${tree}/kernels/passes/mixing_rate.hpp" "#pragma once
#include \"kernels/passes/run.hpp\"
#include \"kernels/terms/friction.hpp\"
namespace sphk {
/// Mixing over the density.
struct MixingRate {
  static constexpr FieldFacts facts{.name = \"MixingRate\", .description = \"Mixing / rho\", .unit = {.length = 1, .time = -1}, .shown = Shown::in_snapshots};
  template <class T, int D>
  struct Value {
    T mixing_rate;
  };
};
template <class L>
struct DivideMixing {
  Particles<L> state;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    state.template at<MixingRate>(i) = state.template at<Mixing>(i) / state.template at<Density>(i);
  }
};
struct MixingRates {
  static constexpr const char* name = \"mixing rates\";
  static constexpr bool essential = true;
  using Reads = List<Mixing, Density>;
  using Writes = List<MixingRate>;
  using Keeps = Writes;
  template <class L>
  static void run(RunOf<L>& run) {
    Kokkos::parallel_for(name, Kokkos::RangePolicy<ExecutionSpace>(0, run.state.n), DivideMixing<L>{run.state.template as<L>()});
  }
};
}
")

file(WRITE "${tree}/src/schemes/rubbing.hpp" "#pragma once
#include \"kernels/passes/mixing_rate.hpp\"
#include \"kernels/terms/pressure_gradient_sph.hpp\"
#include \"kernels/terms/signal_velocity.hpp\"
#include \"src/schemes/step.hpp\"
namespace sphk {
/// SPH with friction in place of viscosity.
struct Rubbing {
  static constexpr SchemeFacts facts{.name = \"rubbing\", .summary = \"SPH with friction\"};
  struct Entropy : Recipe<EntropyForm, DivergenceSum, TermSet<PressureGradientSph, Friction, SignalVelocity>,
                          typename Before<StateEquation>::Then<MixingRates>> {
    using Kernels = Curated<List<Cubed>, List<>, List<>>;
  };
  using Recipes = List<Entropy>;
};
}
")
replace(src/schemes/CMakeLists.txt "set(schemes sph " "set(schemes rubbing sph ")

file(WRITE "${tree}/src/scenes/standing_wave.cpp" "#include <cmath>
#include <numbers>

#include \"src/scenes/keys.hpp\"
#include \"src/scenes/scenes.hpp\"
namespace sphk {
${scene}
const Scene& standing_wave_scene = StandingWave();
}
")
replace(src/scenes/scenes.hpp "  SCENE(uniform)" "  SCENE(standing_wave)     \\\n  SCENE(uniform)")

function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN} ended with ${code}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()
function(expect)
  foreach(word IN LISTS ARGN)
    string(FIND "${output}" "${word}" place)
    if(place EQUAL -1)
      message(SEND_ERROR "\"${word}\" is missing in:\n${output}")
    endif()
  endforeach()
endfunction()

run("${CMAKE_COMMAND}" -G "${GENERATOR}" -C "${SETTINGS}" "-DKokkos_ROOT=${KOKKOS}" -DSPHK_TESTS=OFF -DSPHK_BENCH=OFF
    -DSPHK_SCHEMES=rubbing -S "${tree}" -B "${WORK}/build")
run("${CMAKE_COMMAND}" --build "${WORK}/build" --target sphk --parallel)
set(sphk "${WORK}/build/bin/sphk")
run("${sphk}" list)
expect(standing-wave rubbing "SPH with friction")
run("${sphk}" show standing-wave --scheme rubbing)
expect("friction between neighbours" "mixing rates" friction.k MixingRate)
run("${sphk}" run standing-wave --scheme rubbing --kernel cubed --set friction.k=2 --steps 3 --overwrite --out "${WORK}/run")
run("${sphk}" info "${WORK}/run/snap_0001.hdf5")
expect(Mixing MixingRate)
