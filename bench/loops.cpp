// SPDX-License-Identifier: BSD-3-Clause

// The parts of a step apart: the cell build, the density loop, the rates loop.
#include "bench/measure.hpp"
#include "kernels/passes/gradients.hpp"
#include "kernels/passes/smoothing_length.hpp"
#include "kernels/smoothing/cubic_spline.hpp"
#include "kernels/smoothing/hoct.hpp"
#include "src/engine/output.hpp"
#include "src/engine/recipe_parts.hpp"
#include "src/schemes/gadget2.hpp"
#include "src/schemes/sph.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk::bench {
namespace {

template <class S>
const SmoothingOf<S> smoothing{typename S::Kernel{}};

template <class S>
RunOf<typename S::Layout> loaded(int n, double neighbours) {
  SimulationSettings settings;
  settings.neighbours = neighbours;
  auto run = load_run<S>(shaken_box(n), settings, smoothing<S>);
  StateEquation::run<typename S::Layout>(run);
  return run;
}

template <class S>
inline constexpr bool is_mixed = std::is_same_v<typename S::PairNumber, float>;

/// Sort along the Hilbert curve and into kd order, permutation of all columns, boxes.
template <class S>
void cells(benchmark::State& state) {
  auto run = loaded<S>(64, 48);
  for (auto _ : state) SortedCells::run<typename S::Layout>(run);
  report(state, run.state.n, 0, 0, is_mixed<S>);
}

/// One evaluation of n and rho with their slopes, and the scheme's further sums: the supports are at their roots.
template <class S>
void density_loop(benchmark::State& state, double neighbours) {
  auto run = loaded<S>(64, neighbours);
  for (auto _ : state)
    find_support(State<S>{run.state.template as<typename S::Layout>(), smoothing<S>}, run.given, 1e-2);
  constexpr double flops = flops_of_search<S> + flops_of_density_terms<S>;
  report(state, run.state.n, neighbours, flops, is_mixed<S>);
}

/// Moments, fits of the velocities, gradients.
template <class S>
void gradients_loop(benchmark::State& state, double neighbours) {
  auto run = loaded<S>(64, neighbours);
  for (auto _ : state) Gradients::run<S>(run, smoothing<S>);
  report(state, run.state.n, neighbours, flops_of_fit<S>, is_mixed<S>);
}

/// All terms of the scheme.
template <class S>
void rates_loop(benchmark::State& state, double neighbours) {
  auto run = loaded<S>(64, neighbours);
  for (auto _ : state) Rates::run<S>(run, smoothing<S>);
  constexpr double flops = flops_of_rates<S>;
  report(state, run.state.n, neighbours, flops, is_mixed<S>);
}

using Classic48 = Scheme<Gadget2::Entropy, 3, CubicSpline, float>;
using Classic48Double = Scheme<Gadget2::Entropy, 3, CubicSpline, double>;
using Hoct442 = Scheme<Sph::Entropy, 3, Hoct<4>, float>;
using Hoct442Double = Scheme<Sph::Entropy, 3, Hoct<4>, double>;
using Sphs442 = Scheme<Sphs::EqualEntropy, 3, Hoct<4>, float>;
using Sphs442Double = Scheme<Sphs::EqualEntropy, 3, Hoct<4>, double>;

const auto registered = [] {
  const auto add = [](const char* name, auto function, auto... arguments) {
    benchmark::RegisterBenchmark(name, function, arguments...)->Unit(benchmark::kMillisecond)->UseRealTime();
  };
  add("cells", cells<Classic48>);
  add("density_loop/gadget2_cs_48_mixed", density_loop<Classic48>, 48);
  add("density_loop/gadget2_cs_48_double", density_loop<Classic48Double>, 48);
  add("density_loop/sph_hoct4_442_mixed", density_loop<Hoct442>, 442);
  add("density_loop/sph_hoct4_442_double", density_loop<Hoct442Double>, 442);
  add("density_loop/sphs_hoct4_442_mixed", density_loop<Sphs442>, 442);
  add("density_loop/sphs_hoct4_442_double", density_loop<Sphs442Double>, 442);
  add("gradients_loop/sphs_hoct4_442_mixed", gradients_loop<Sphs442>, 442);
  add("gradients_loop/sphs_hoct4_442_double", gradients_loop<Sphs442Double>, 442);
  add("rates_loop/sphs_hoct4_442_mixed", rates_loop<Sphs442>, 442);
  add("rates_loop/sphs_hoct4_442_double", rates_loop<Sphs442Double>, 442);
  add("rates_loop/gadget2_cs_48_mixed", rates_loop<Classic48>, 48);
  add("rates_loop/gadget2_cs_48_double", rates_loop<Classic48Double>, 48);
  add("rates_loop/sph_hoct4_442_mixed", rates_loop<Hoct442>, 442);
  add("rates_loop/sph_hoct4_442_double", rates_loop<Hoct442Double>, 442);
  return true;
}();

}  // namespace
}  // namespace sphk::bench
