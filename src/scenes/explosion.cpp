// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/explosion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "src/engine/errors.hpp"
#include "src/scenes/block.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/norms.hpp"
#include "src/scenes/sedov_solution.hpp"

namespace sphk {

namespace {

constexpr double density = 1;

/// Mean distance from the origin, weighted with the kinetic energy, of the particles whose place `counts`: it moves
/// with a shock and does not feel how wide that is smeared.
template <class F>
double kinetic_radius(const Snapshot& snapshot, F&& counts) {
  const auto x = rows(snapshot.field("Coordinates")), v = rows(snapshot.field("Velocities"));
  const auto& m = snapshot.field("Masses").values;
  double sum = 0, energy = 0;
  for (std::size_t i = 0; i < m.size(); ++i) {
    if (!counts(x[i])) continue;
    const double one = m[i] * dot(v[i], v[i]);
    sum += one * radius(x[i]);
    energy += one;
  }
  return energy > 0 ? sum / energy : 0;
}

/// The spread of that radius over cones along +x, -x, +y and so on: largest less smallest, over the mean. On the edge
/// of a cone, at an angle of arccos(3/4), lies no site of a lattice.
double roundness(const Snapshot& snapshot) {
  double least = std::numeric_limits<double>::infinity(), most = 0, sum = 0;
  for (int axis = 0; axis < snapshot.dimension; ++axis)
    for (const int side : {-1, 1}) {
      const double here = kinetic_radius(snapshot, [&](const Array3& x) { return side * x[axis] > 0.75 * radius(x); });
      least = std::min(least, here);
      most = std::max(most, here);
      sum += here;
    }
  return sum > 0 ? (most - least) / (sum / (2 * snapshot.dimension)) : 0;
}

/// The mean radius of the exact solution, in units of the shock's radius.
double kinetic_radius(const SedovSolution& solution, int dimension) {
  const double R = solution.shock_radius(1, density, 1);
  constexpr int points = 4000;
  double sum = 0, energy = 0;
  for (int k = 0; k < points; ++k) {
    const double q = (k + 0.5) / points;
    const GasState state = solution.behind_shock(q * R, 1, density, 1);
    const double one = state.rho * state.v[0] * state.v[0] * std::pow(q, dimension - 1);
    sum += one * q;
    energy += one;
  }
  return sum / energy;
}

/// The unit box around the origin in one block, or with scene.coarser = k > 1 in two, of which that at the end of the x
/// axis begins at the first place from 0.125 on where both lattices end on whole cells.
std::vector<Block> blocks_of(const Settings& settings) {
  const int D = scene_dimension(settings), n = scene_n(settings);
  const int coarser = static_cast<int>(settings.integer("scene.coarser"));
  Block fine = centred_cube(D, n, 0.5);
  if (coarser == 1) return {fine};
  if (n % coarser != 0 || n < 3 * coarser)
    throw InputError(
        fmt::format("scene.n = {} with scene.coarser = {}: both lattices fit the box for multiples of it, from {} on",
                    n, coarser, 3 * coarser));
  Block coarse = fine;
  coarse.counts = even_counts(D, n / coarser);
  coarse.counts[0] = 3 * n / (8 * coarser);
  coarse.size[0] = static_cast<double>(coarse.counts[0] * coarser) / n;
  fine.counts[0] = n - coarse.counts[0] * coarser;
  fine.size[0] = static_cast<double>(fine.counts[0]) / n;
  coarse.lower[0] += fine.size[0];
  return {fine, coarse};
}

}  // namespace

void Explosion::declare(Settings& settings) const {
  declare_resolution(settings, 64, "particles along the unit box");
  declare_dimension(settings, 3);
  declare_arrangement(settings, "cubic");
  declare_real(settings, "scene.energy", 1.0, "energy of the explosion", {.min = 1e-300});
  declare_integer(settings, "scene.coarser", 1, "from x = 0.125 on particles on a lattice this many times coarser",
                  {.min = 1, .max = 100});
  prefer_usual_gas(settings, 0.05);
}

ParticleSet Explosion::build(const Settings& settings) const {
  ParticleSet gas;
  gas.dimension = scene_dimension(settings);
  for (int axis = 0; axis < gas.dimension; ++axis) gas.box.lower[axis] = -0.5, gas.box.periodic[axis] = true;
  for (const Block& block : blocks_of(settings)) add_block(gas, block, settings.text("scene.lattice"), density);
  gas.u.assign(gas.size(), GasState{.rho = density, .P = ambient_pressure(settings)}.u(settings.real("sph.gamma")));
  explode(gas, settings);
  return gas;
}

ExactSolution Explosion::exact(const Settings& settings) const {
  const double E = settings.real("scene.energy"), P = ambient_pressure(settings), begin = start(settings);
  const auto solution = std::make_shared<SedovSolution>(scene_dimension(settings), settings.real("sph.gamma"));
  return [=](const Array3& x, double time) -> GasState {
    const double r = radius(x), t = time - begin;
    if (t <= 0 || r >= solution->shock_radius(E, density, t)) return {density, {}, P};
    GasState state = solution->behind_shock(r, E, density, t);
    const double v = state.v[0] / std::max(r, 1e-300);
    state.v = {v * x[0], v * x[1], v * x[2]};
    return state;
  };
}

Errors Explosion::errors(const Settings& settings, const Snapshot& snapshot) const {
  return profile_errors(snapshot, along_r(0.5), exact(settings));
}

Measures Explosion::measures(const Settings& settings, const Snapshot& snapshot) const {
  const SedovSolution solution(scene_dimension(settings), settings.real("sph.gamma"));
  const double t = snapshot.time - start(settings);
  const double exact = t > 0 ? solution.shock_radius(settings.real("scene.energy"), density, t) : 0;
  const double blast = kinetic_radius(snapshot, [](const Array3&) { return true; }) /
                       kinetic_radius(solution, scene_dimension(settings));
  return {{"peak_density", std::ranges::max(snapshot.field("Densities").values)},
          {"blast_radius", blast},
          {"blast_radius_exact", exact},
          {"roundness", roundness(snapshot)}};
}

}  // namespace sphk
