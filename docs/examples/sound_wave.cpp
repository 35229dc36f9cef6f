#include <Kokkos_Core.hpp>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <sphk.hpp>

// A weak standing wave in a periodic tube: ten steps of the default scheme, through the library.
int main(int argc, char** argv) {
  const Kokkos::ScopeGuard kokkos(argc, argv);
  constexpr int n = 100;
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
  sphk::SimulationSettings settings;
  settings.neighbours = 4;
  const auto simulation = sphk::make_simulation(gas, settings);
  const double energy = simulation->totals().energy();
  for (int k = 0; k < 10; ++k) simulation->step(1.0);
  const double drift = std::abs(simulation->totals().energy() / energy - 1);
  std::printf("time %g, energy drift %g\n", simulation->time(), drift);
  return simulation->time() > 0 && drift < 2.5e-5 ? 0
                                                  : 1;  // less than the wave's share of the energy, <v^2>/2 = 2.5e-5
}
