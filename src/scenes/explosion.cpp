#include "src/scenes/explosion.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "src/scenes/block.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/norms.hpp"
#include "src/scenes/sedov_solution.hpp"

namespace sphk {

namespace {

constexpr double density = 1;

/// Mean distance from the origin, weighted with the kinetic energy: it moves with a shock and does not feel how wide
/// that is smeared.
double kinetic_radius(const Snapshot& snapshot) {
  const auto &x = snapshot.field("Coordinates").values, &v = snapshot.field("Velocities").values;
  const auto& m = snapshot.field("Masses").values;
  double sum = 0, energy = 0;
  for (std::size_t i = 0; i < m.size(); ++i) {
    const double one = m[i] * (v[3 * i] * v[3 * i] + v[3 * i + 1] * v[3 * i + 1] + v[3 * i + 2] * v[3 * i + 2]);
    sum += one * std::hypot(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
    energy += one;
  }
  return energy > 0 ? sum / energy : 0;
}

/// The same of the exact solution, in units of the shock's radius.
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

}  // namespace

void Explosion::declare(Settings& settings) const {
  declare_resolution(settings, 64, "particles along the unit box");
  declare_dimension(settings, 3);
  declare_arrangement(settings, "cubic");
  settings.declare(
      {.name = "scene.energy", .value = 1.0, .doc = "energy of the explosion", .choices = {}, .min = 1e-300});
  prefer_usual_gas(settings, 0.05);
  adapt(settings);
}

void Explosion::adapt(Settings& settings) const {
  prefer_usual_kernel(settings, scene_dimension(settings));
}

ParticleSet Explosion::build(const Settings& settings) const {
  const int D = scene_dimension(settings), n = scene_n(settings);
  Block block{.dimension = D, .counts = even_counts(D, n)};
  for (int axis = 0; axis < D; ++axis) block.lower[axis] = -0.5;
  ParticleSet gas;
  gas.dimension = D;
  gas.box = {block.lower, block.size, {true, D > 1, D > 2}};
  gas.x = arranged_points(block, settings.text("scene.lattice"));
  gas.v.assign(gas.size(), {});
  gas.m.assign(gas.size(), density / double(gas.size()));
  gas.u.assign(gas.size(), ambient_pressure(settings) / ((settings.real("sph.gamma") - 1) * density));
  explode(gas, settings);
  return gas;
}

std::function<GasState(const Array3&, double)> Explosion::exact(const Settings& settings) const {
  const double E = settings.real("scene.energy"), P = ambient_pressure(settings);
  const auto solution = std::make_shared<SedovSolution>(scene_dimension(settings), settings.real("sph.gamma"));
  return [=](const Array3& x, double t) -> GasState {
    const double r = radius(x);
    if (t <= 0 || r >= solution->shock_radius(E, density, t)) return {density, {}, P};
    GasState state = solution->behind_shock(r, E, density, t);
    const double v = state.v[0] / std::max(r, 1e-300);
    state.v = {v * x[0], v * x[1], v * x[2]};
    return state;
  };
}

std::map<std::string, ErrorNorm> Explosion::errors(const Settings& settings, const Snapshot& snapshot) const {
  return profile_errors(snapshot, along_r(0.5), exact(settings));
}

std::vector<std::pair<std::string, double>> Explosion::measures(const Settings& settings,
                                                                const Snapshot& snapshot) const {
  const SedovSolution solution(scene_dimension(settings), settings.real("sph.gamma"));
  const double exact = snapshot.time > 0 ? solution.shock_radius(settings.real("scene.energy"), density, snapshot.time) : 0;
  const double blast = kinetic_radius(snapshot) / kinetic_radius(solution, scene_dimension(settings));
  return {{"peak_density", std::ranges::max(snapshot.field("Densities").values)},
          {"blast_radius", blast},
          {"blast_radius_exact", exact}};
}

}  // namespace sphk
