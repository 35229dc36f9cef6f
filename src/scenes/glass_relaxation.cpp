#include "src/scenes/glass_relaxation.hpp"

#include <cmath>
#include <limits>

#include "src/scenes/keys.hpp"
#include "src/scenes/scene.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

namespace {

/// Root mean square of density / mean density - 1.
double scatter(const std::vector<double>& density) {
  double sum = 0, squares = 0;
  for (const double rho : density) sum += rho, squares += rho * rho;
  const double mean = sum / double(density.size());
  return std::sqrt(std::max(squares / double(density.size()) / (mean * mean) - 1, 0.0));
}

/// An isothermal gas: P ~ rho alike for all particles, although their entropies follow from the start's uneven density.
constexpr double nearly_one = 1 + 1e-6;

}  // namespace

std::vector<Array3> relax_with_engine(int dimension, const Array3& size, std::vector<Array3> start) {
  ParticleSet gas;
  gas.dimension = dimension;
  for (int axis = 0; axis < dimension; ++axis) gas.box.size[axis] = size[axis], gas.box.periodic[axis] = true;
  gas.v.assign(start.size(), {});
  gas.m.assign(start.size(), 1);
  gas.u.assign(start.size(), 1 / (nearly_one - 1));
  gas.x = std::move(start);

  SimulationSettings settings;
  settings.scheme = "glass";
  settings.gamma = nearly_one;
  const auto simulation = make_simulation(gas, settings);

  constexpr int most_steps = 1000, steps_between_looks = 20;
  double before = std::numeric_limits<double>::infinity();
  for (int step = 1; step <= most_steps; ++step) {
    simulation->step(std::numeric_limits<double>::max());
    if (step % steps_between_looks != 0) continue;
    const double now = scatter(simulation->snapshot().field("Densities").values);
    if (now > 0.98 * before) break;
    before = now;
  }
  return rows(simulation->snapshot().field("Coordinates"));
}

}  // namespace sphk
