// SPDX-License-Identifier: BSD-3-Clause
#include <Kokkos_Core.hpp>
#include <cstdio>

#include "kernels/passes/smoothing_length.hpp"
#include "kernels/smoothing/cubic_spline.hpp"
#include "src/engine/error_loops.hpp"
#include "src/engine/recipe_parts.hpp"
#include "src/schemes/gadget2.hpp"
#include "src/schemes/loops.hpp"
#include "src/schemes/osph_coherent.hpp"
#include "src/schemes/sphs.hpp"

// Every pass and one scheme per dimension through nvcc and its linker. Where there is a GPU it also runs: a lattice at
// rest with one pressure stays at rest, for the forces on a particle of a periodic lattice cancel.
template <class Recipe, int D>
double fastest_after_one_step() {
  constexpr int side = 16;
  sphk::ParticleSet gas;
  gas.dimension = D;
  int n = 1;
  for (int d = 0; d < D; ++d) {
    gas.box.periodic[d] = true;
    n *= side;
  }
  for (int i = 0; i < n; ++i) {
    const int cell[] = {i % side, D > 1 ? i / side % side : 0, D > 2 ? i / side / side : 0};
    sphk::Array3 x{};
    for (int d = 0; d < D; ++d) x[d] = (cell[d] + 0.5) / side;
    gas.x.push_back(x);
    gas.v.push_back({});
    gas.m.push_back(1.0 / n);
    gas.u.push_back(1.0);
    gas.id.push_back(i + 1);
  }
  sphk::SimulationSettings settings;
  settings.neighbours = D == 1 ? 5 : D == 2 ? 14 : 48;
  using Scheme = sphk::Scheme<Recipe, D, sphk::CubicSpline, double>;
  settings.courant = 0.2;
  const auto run = sphk::make_run<sphk::BaseLayout<typename Scheme::Layout>>(
      gas, settings, std::make_unique<sphk::PassesOf<Scheme>>(sphk::CubicSpline{}));
  run->step(1.0);
  return run->totals().max_speed;
}

int main() {
  const Kokkos::ScopeGuard kokkos(Kokkos::InitializationSettings().set_disable_warnings(true));
  const double fastest[] = {
      fastest_after_one_step<sphk::OsphCoherent::Entropy, 1>(), fastest_after_one_step<sphk::Gadget2::Entropy, 1>(),
      fastest_after_one_step<sphk::Gadget2::Entropy, 2>(), fastest_after_one_step<sphk::Gadget2::Entropy, 3>(),
      fastest_after_one_step<sphk::Sphs::Entropy, 3>()};
  bool at_rest = true;
  for (const double v : fastest) {
    std::printf("%g\n", v);
    at_rest = at_rest && v < 1e-12;  // sound speed 1: round-off of the cancelling sums
  }
  return at_rest ? 0 : 1;
}
