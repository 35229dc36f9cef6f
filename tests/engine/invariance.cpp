// SPDX-License-Identifier: BSD-3-Clause

// What must not change a result: the order of the input, a boost, float against double pairs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "src/schemes/registry.hpp"
#include "tests/engine/brute_force.hpp"

namespace sphk::test {
namespace {

SimulationSettings settings_of(const std::string& precision) {
  SimulationSettings s;
  s.scheme = "gadget2";
  s.kernel = "cs";
  s.neighbours = 48;
  s.precision = precision;
  return s;
}

Snapshot after_steps(const ParticleSet& gas, const SimulationSettings& settings, int steps) {
  const auto run = make_simulation(gas, settings);
  for (int step = 0; step < steps; ++step) run->step(1e9);
  return run->snapshot();
}

/// Largest difference of a field over its largest value; periodic differences of positions are folded.
double difference(const Snapshot& a, const Snapshot& b, const std::string& name) {
  const auto &x = a.field(name).values, &y = b.field(name).values;
  double most = 0, scale = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    double d = std::abs(x[k] - y[k]);
    if (name == "Coordinates") d = std::min(d, std::abs(a.box.size[k % 3] - d));
    most = std::max(most, d);
    scale = std::max(scale, std::abs(x[k]));
  }
  return most / scale;
}

TEST(Invariance, OrderOfTheInputChangesRoundingsAlone) {
  ParticleSet gas = shaken_lattice(3, {8, 8, 8}, 0.3, true, 9);
  for (std::size_t i = 0; i < gas.size(); ++i) gas.id.push_back(i + 1);
  const Snapshot straight = after_steps(gas, settings_of("double"), 5);
  std::vector<int> order(gas.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  ParticleSet shuffled = gas;
  for (std::size_t i = 0; i < gas.size(); ++i) {
    const int from = order[i];
    shuffled.x[i] = gas.x[from], shuffled.v[i] = gas.v[from], shuffled.m[i] = gas.m[from];
    shuffled.u[i] = gas.u[from], shuffled.id[i] = gas.id[from];
  }
  const Snapshot other = after_steps(shuffled, settings_of("double"), 5);
  EXPECT_EQ(straight.id, other.id);
  for (const char* name : {"Coordinates", "Velocities", "Densities", "Entropies"})
    EXPECT_LT(difference(straight, other, name), 1e-12) << name;
}

/// A boost by 1e4 sound speeds in float pairs: relative velocities and coordinates keep their digits, so the flow is
/// that of the box at rest but for the roundings of x and v in double (1e4 * 1e-16) and of float pairs (1e-6).
TEST(Invariance, ABoostChangesNoDensity) {
  ParticleSet gas = shaken_lattice(3, {8, 8, 8}, 0.3, true, 10);
  const Snapshot rest = after_steps(gas, settings_of("mixed"), 10);
  for (Array3& v : gas.v) v[0] += 1e4, v[1] -= 5e3;
  const Snapshot boosted = after_steps(gas, settings_of("mixed"), 10);
  EXPECT_LT(difference(rest, boosted, "Densities"), 2e-5);
  EXPECT_LT(difference(rest, boosted, "Entropies"), 2e-5);
}

/// Searches for h end at moves of 3e-3 in mixed runs, and the slopes that forces read are those before the move: that,
/// not float rounding, bounds the difference.
TEST(Invariance, MixedFollowsDouble) {
  const ParticleSet gas = shaken_lattice(3, {10, 10, 10}, 0.2, true, 11);
  const Snapshot single = after_steps(gas, settings_of("mixed"), 10),
                 full = after_steps(gas, settings_of("double"), 10);
  for (const char* name : {"Coordinates", "Velocities", "Densities", "Entropies", "SmoothingLength"})
    EXPECT_LT(difference(full, single, name), 3e-3) << name;
}

}  // namespace
}  // namespace sphk::test
