// Cost of an update where only some particles are active.
#include <cmath>
#include <numbers>
#include <random>

#include "bench/measure.hpp"
#include "kernels/passes/gradients.hpp"
#include "kernels/passes/smoothing_length.hpp"
#include "kernels/smoothing/hoct.hpp"
#include "src/engine/passes_of.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk::bench {
namespace {

using S = Sphs<3, Hoct<4>, float>;

template <class... P>
void run_passes(RunOf<S::Layout>& run, const SmoothingOf<S>& smoothing, Passes<P...>) {
  (run_pass<P, S>(run, smoothing), ...);
}

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
  const SmoothingOf<S> smoothing(Hoct<4>{});
  auto run = load_run<S>(shaken_box(64), settings, smoothing);
  auto& clock = run.state.clock;
  clock.tick = 1e-20;  // nothing moves: every sub-step is the same
  run_passes(run, smoothing, S::Steps{});
  const std::vector<bool> active = choose_active(run, static_cast<double>(state.range(0)), where);
  double updates = 0;
  for (auto _ : state) {
    state.PauseTiming();
    clock.now = 4096;
    clock.next = 4096 + 64;
    run.schedule.updates_since_sort = 0;
    for (int i = 0; i < run.state.n; ++i)
      clock.begin(i) = 4096 - (active[i] ? 0 : 64), clock.end(i) = active[i] ? clock.next : clock.next + 64;
    state.ResumeTiming();
    run_passes(run, smoothing, S::Steps{});
    updates += static_cast<double>(run.active_count);
  }
  report(state, updates / static_cast<double>(state.iterations()), 0, 0, true);
}

BENCHMARK_CAPTURE(active_step, all, Where::ball)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(active_step, ball, Where::ball)->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(active_step, scattered, Where::scattered)
    ->Arg(3)
    ->Arg(10)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace sphk::bench
