// SPDX-License-Identifier: BSD-3-Clause

// A run under the scheme of own_scheme.hpp.
#include <cstdio>

#include "own_scheme.hpp"

int main(int argc, char** argv) {
  const Kokkos::ScopeGuard kokkos(argc, argv);
  Settings settings;
  StandingWave().declare(settings);
  double kinetic[2];
  for (const int k : {0, 1}) {
    const auto run = make_simulation<Rubbing>(StandingWave().build(settings), {.numbers = {{"friction.k", k}}});
    while (run->time() < 0.2) run->step(0.2);
    kinetic[k] = run->totals().kinetic;
    std::printf("k = %d: kinetic energy %.3e, mixing %.3e\n", k, kinetic[k], run->snapshot().field("Mixing").values[0]);
  }
  return kinetic[1] < kinetic[0] ? 0 : 1;  // friction slows the wave
}
