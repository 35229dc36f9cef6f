// Whole time-steps, every particle active, over sizes, neighbour numbers and precisions.
#include "bench/measure.hpp"
#include "src/schemes/registry.hpp"

namespace sphk::bench {
namespace {

void whole_step(benchmark::State& state, const char* scheme, const char* kernel, double neighbours,
                const char* precision) {
  const ParticleSet gas = shaken_box(static_cast<int>(state.range(0)));
  SimulationSettings settings;
  settings.scheme = scheme;
  settings.kernel = kernel;
  settings.neighbours = neighbours;
  settings.precision = precision;
  const auto run = make_simulation(gas, settings);
  for (int step = 0; step < 2; ++step) run->step(1e9);
  const Costs before = run->costs();
  for (auto _ : state) run->step(1e9);
  const Costs after = run->costs();
  const double updates =
      double(gas.size()) * double(state.iterations()) / Kokkos::DefaultExecutionSpace().concurrency();
  for (std::size_t k = 0; k < after.phases.size(); ++k)
    state.counters["us: " + after.phases[k].first] = 1e6 * (after.phases[k].second - before.phases[k].second) / updates;
  report(state, double(gas.size()), run->last_step().mean_neighbours, describe(settings, gas).flops_per_pair,
         settings.precision == "mixed");
}

BENCHMARK_CAPTURE(whole_step, gadget2_cs_48_mixed, "gadget2", "cs", 48.0, "mixed")
    ->Arg(16)
    ->Arg(32)
    ->Arg(64)
    ->Arg(128)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(whole_step, gadget2_cs_48_double, "gadget2", "cs", 48.0, "double")
    ->Arg(64)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(whole_step, sph_cs_48_mixed, "sph", "cs", 48.0, "mixed")
    ->Arg(64)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(whole_step, sph_hoct4_442_mixed, "sph", "hoct4", 442.0, "mixed")
    ->Arg(64)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(whole_step, sph_hoct4_442_double, "sph", "hoct4", 442.0, "double")
    ->Arg(64)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(whole_step, tsph_wc6_table_442_mixed, "tsph", "wc6", 442.0, "mixed")
    ->Arg(32)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace sphk::bench
