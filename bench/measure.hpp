// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <benchmark/benchmark.h>

#include <Kokkos_Core.hpp>
#include <cmath>
#include <random>

#include "src/engine/particle_set.hpp"
#include "src/engine/simulation.hpp"
#include "src/report/fma_peak.hpp"

namespace sphk::bench {

/// A periodic unit box of n^3 equal particles, a lattice shaken by 0.2 spacings, with random velocities of a tenth of
/// the sound speed: what the cost of an even gas is measured on.
inline ParticleSet shaken_box(int n) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> shake(-0.2, 0.2);
  ParticleSet gas;
  gas.box.periodic = {true, true, true};
  const double spacing = 1.0 / n;
  for (int k = 0; k < n * n * n; ++k) {
    const int index[3] = {k % n, k / n % n, k / (n * n)};
    Array3 x{}, v{};
    for (int d = 0; d < 3; ++d) x[d] = (index[d] + 0.5 + shake(engine)) * spacing, v[d] = 0.5 * shake(engine);
    gas.x.push_back(x);
    gas.v.push_back(v);
  }
  gas.m.assign(gas.x.size(), spacing * spacing * spacing);
  gas.u.assign(gas.x.size(), 1.0);
  return gas;
}

/// Counters of a benchmark that updates `particles` particles an iteration: updates per second and core, microseconds
/// of one core per update, pairs per second, and the share of the FMA peak that this program measures at its start.
inline void report(benchmark::State& state, double particles, double neighbours, double flops_per_pair, bool mixed) {
  static const FmaPeak peak = measure_fma_peak();
  const double cores = Kokkos::DefaultExecutionSpace().concurrency();
  const double updates = particles * double(state.iterations());
  const auto rate = [](double count) { return benchmark::Counter(count, benchmark::Counter::kIsRate); };
  state.counters["updates/s/core"] = rate(updates / cores);
  state.counters["us/update"] =
      benchmark::Counter(1e-6 * updates / cores, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  if (neighbours == 0) return;
  state.counters["pairs/s"] = rate(updates * neighbours);
  state.counters["share_of_peak"] = rate(updates * neighbours * flops_per_pair / (mixed ? peak.single : peak.twofold));
}

}  // namespace sphk::bench
