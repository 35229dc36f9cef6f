// Cost of an update where only some particles are active, scattered at random.
#include <random>

#include "bench/measure.hpp"
#include "kernels/smoothing/hoct.hpp"
#include "src/engine/loading.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk::bench {
namespace {

using S = Sphs<3, Hoct<4>, float>;

template <class... P>
void run_passes(Run<S>& run, Passes<P...>) {
  (P::run(run), ...);
}

/// A whole sub-step of SPHS-442 with one of `every` particles active: all are drifted and predicted, the active ones
/// are computed, kicked and get new steps.
void active_step(benchmark::State& state) {
  SimulationSettings settings;
  settings.neighbours = 442;
  settings.individual_steps = true;
  settings.courant = 0.2;
  Run<S> run = load_run<S>(shaken_box(64), settings, Hoct<4>{});
  auto& clock = run.state.clock;
  clock.tick = 1e-20;  // nothing moves: every sub-step is the same
  run_passes(run, S::Steps{});
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<bool> active(run.state.n);
  for (int i = 0; i < run.state.n; ++i) active[i] = unit(engine) * static_cast<double>(state.range(0)) < 1;
  double updates = 0;
  for (auto _ : state) {
    state.PauseTiming();
    clock.now = 4096;
    clock.next = 4096 + 64;
    run.schedule.updates_since_sort = 0;
    for (int i = 0; i < run.state.n; ++i)
      clock.begin(i) = 4096 - (active[i] ? 0 : 64), clock.end(i) = active[i] ? clock.next : clock.next + 64;
    state.ResumeTiming();
    run_passes(run, S::Steps{});
    updates += static_cast<double>(run.active_count);
  }
  report(state, updates / static_cast<double>(state.iterations()), 0, 0, true);
}

BENCHMARK(active_step)->Arg(1)->Arg(3)->Arg(10)->Arg(30)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace sphk::bench
