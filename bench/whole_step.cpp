// SPDX-License-Identifier: BSD-3-Clause

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

const auto registered = [] {
  const auto add = [](const char* name, const char* scheme, const char* kernel, double neighbours,
                      const char* precision, std::vector<int> sizes) {
    const std::string full = std::string("whole_step/") + name + "_" + precision;
    auto* one = benchmark::RegisterBenchmark(full.c_str(), whole_step, scheme, kernel, neighbours, precision);
    for (const int n : sizes) one->Arg(n);
    one->Unit(benchmark::kMillisecond)->UseRealTime();
  };
  add("gadget2_cs_48", "gadget2", "cs", 48, "mixed", {16, 32, 64, 128});
  add("gadget2_cs_48", "gadget2", "cs", 48, "double", {64});
  add("sph_cs_48", "sph", "cs", 48, "mixed", {64});
  for (const char* precision : {"mixed", "double"}) {
    add("sph_hoct4_442", "sph", "hoct4", 442, precision, {64});
    add("osph_hoct4_442", "osph", "hoct4", 442, precision, {64});
    add("sphs_hoct4_442", "sphs", "hoct4", 442, precision, {64});
  }
  add("tsph_wc6_table_442", "tsph", "wc6", 442, "mixed", {32});
  return true;
}();

}  // namespace
}  // namespace sphk::bench
