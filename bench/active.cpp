// SPDX-License-Identifier: BSD-3-Clause

// Cost of an update where only some particles are active, and of a blast with steps of the particles' own.
#include <cmath>
#include <numbers>
#include <random>

#include "bench/measure.hpp"
#include "kernels/passes/gradients.hpp"
#include "kernels/passes/schedule.hpp"
#include "kernels/passes/smoothing_length.hpp"
#include "kernels/smoothing/hoct.hpp"
#include "src/engine/recipe_parts.hpp"
#include "src/schemes/registry.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk::bench {
namespace {

using S = Scheme<Sphs::EqualEntropy, 3, Hoct<4>, float>;

/// Which particles are active: one of `every`, scattered at random, or all in a ball, as steps of the particles' own
/// have them, which change by a factor 4 at most from one neighbour to the next.
enum class Where { scattered, ball };

std::vector<bool> choose_active(const RunOf<S::Layout>& run, double every, Where where) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> unit(0, 1);
  const double radius = std::cbrt(3 / (4 * std::numbers::pi * every));
  std::vector<bool> active(run.state.n);
  for (int i = 0; i < run.state.n; ++i) {
    double r2 = 0;
    for (int d = 0; d < 3; ++d) r2 += std::pow(run.state.at<Position>(i, d) - 0.5, 2);
    active[i] = every == 1 || (where == Where::scattered ? unit(engine) * every < 1 : r2 < radius * radius);
  }
  return active;
}

/// A whole sub-step of SPHS-442 with one of `every` particles active: all are drifted and predicted, the active ones
/// are computed, kicked and get new steps.
void active_step(benchmark::State& state, Where where) {
  SimulationSettings settings;
  settings.neighbours = 442;
  settings.steps = own_steps;
  settings.courant = 0.2;
  const PassesOf<S> passes(Hoct<4>{});
  auto run = load_run<S>(shaken_box(64), settings, SmoothingOf<S>(Hoct<4>{}));
  const auto run_passes = [&] {
    for (std::size_t k = 0; k < passes.facts.passes.size(); ++k)
      if (passes.facts.passes[k].wanted(run.given)) passes.run(static_cast<int>(k), run);
  };
  auto& clock = run.state.clock;
  clock.tick = 1e-20;  // nothing moves: every sub-step is the same
  run.schedule.longest = 64 * clock.tick;
  run_passes();
  const std::vector<bool> active = choose_active(run, static_cast<double>(state.range(0)), where);
  double updates = 0;
  for (auto _ : state) {
    state.PauseTiming();
    clock.now = 4096;
    clock.next = 4096 + 64;
    run.schedule.updates_since_sort = 0;
    for (int i = 0; i < run.state.n; ++i) {
      clock.begin(i) = 4096 - (active[i] ? 0 : 64), clock.end(i) = active[i] ? clock.next : clock.next + 64;
      clock.power(i) = 6;
    }
    fit_ranges(run.state, run.schedule);
    state.ResumeTiming();
    run_passes();
    updates += static_cast<double>(run.active_count);
  }
  report(state, updates / static_cast<double>(state.iterations()), 0, 0, true);
}

/// Classic SPH with steps of the particles' own from a blast in 32 particles of cold gas until its shock has gone over
/// 12 spacings (Sedov's r = 1.15 (E t^2/rho)^(1/5)).
void blast(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  ParticleSet gas = shaken_box(n);
  const double radius = std::cbrt(32 * 3 / (4 * std::numbers::pi)) / n;
  std::vector<std::size_t> hot;
  for (std::size_t i = 0; i < gas.size(); ++i) {
    gas.v[i] = {};
    gas.u[i] = 1e-6;
    double r2 = 0;
    for (int d = 0; d < 3; ++d) r2 += std::pow(gas.x[i][d] - 0.5, 2);
    if (r2 < radius * radius) hot.push_back(i);
  }
  for (const std::size_t i : hot) gas.u[i] = 1 / (static_cast<double>(hot.size()) * gas.m[i]);
  SimulationSettings settings;
  settings.scheme = "gadget2";
  settings.steps = own_steps;
  const double end = std::pow(12.0 / n / 1.15, 2.5);
  double updates = 0;
  for (auto _ : state) {
    state.PauseTiming();
    const auto run = make_simulation(gas, settings);
    state.ResumeTiming();
    while (run->time() < end) run->step(end);
    updates += static_cast<double>(run->costs().updates);
  }
  const auto runs = static_cast<double>(state.iterations());
  state.counters["updates_of_the_box"] = updates / runs / static_cast<double>(gas.size());
  report(state, updates / runs, 0, 0, true);
}

BENCHMARK_CAPTURE(active_step, all, Where::ball)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(active_step, ball, Where::ball)->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(active_step, scattered, Where::scattered)
    ->Arg(3)
    ->Arg(10)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(blast)->Arg(64)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace sphk::bench
