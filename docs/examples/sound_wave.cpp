// SPDX-License-Identifier: BSD-3-Clause

// A weak standing wave in a periodic tube, by the default scheme, through the library.
#include <Kokkos_Core.hpp>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <sphk.hpp>

sphk::ParticleSet wave(int n) {
  sphk::ParticleSet gas;
  gas.dimension = 1;
  gas.box.periodic = {true, false, false};
  for (int i = 0; i < n; ++i) {
    const double x = (i + 0.5) / n;
    gas.x.push_back({x, 0, 0});
    gas.v.push_back({0.01 * std::sin(2 * std::numbers::pi * x), 0, 0});
    gas.m.push_back(1.0 / n);
    gas.u.push_back(1.0);
  }
  return gas;
}

int main(int argc, char** argv) {
  const Kokkos::ScopeGuard kokkos(argc, argv);  // the library never initialises Kokkos
  const auto run = sphk::make_simulation(wave(100), {.scheme = "gadget2", .numbers = {{"viscosity.alpha", 0.5}}});
  const double energy = run->totals().energy();
  while (run->time() < 0.1) run->step(0.1);
  const sphk::Snapshot end = run->snapshot();
  const double drift = std::abs(run->totals().energy() / energy - 1);
  std::printf("time %g, %zu particles, energy drift %g\n", end.time, end.size(), drift);
  return drift < 2.5e-5 ? 0 : 1;  // less than the wave's share of the energy, <v^2>/2 = 2.5e-5
}
