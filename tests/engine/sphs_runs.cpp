// SPDX-License-Identifier: BSD-3-Clause

// Whole steps of SPHS: what is conserved, what a boost changes, what leaving out changes, steps of the particles' own.
#include <gtest/gtest.h>

#include <cmath>

#include "src/schemes/registry.hpp"
#include "tests/engine/brute_force.hpp"

namespace sphk::test {
namespace {

SimulationSettings in_double() {
  SimulationSettings s;
  s.scheme = "sphs", s.kernel = "hoct4", s.neighbours = 100, s.precision = "double", s.courant = 0.2;
  s.steps = global_steps;
  return s;
}

ParticleSet unequal_gas(double boost) {
  ParticleSet gas = shaken_lattice(3, {9, 8, 8}, 0.3, true, 31);
  for (Array3& v : gas.v) v[0] += boost;
  return gas;
}

double largest_difference(const Field& a, const Field& b) {
  double most = 0;
  for (std::size_t k = 0; k < a.values.size(); ++k) most = std::max(most, std::abs(a.values[k] - b.values[k]));
  return most;
}

Snapshot after_steps(const ParticleSet& gas, const SimulationSettings& s, int steps) {
  const auto run = make_simulation(gas, s);
  for (int step = 0; step < steps; ++step) run->step(1e9);
  return run->snapshot();
}

/// F_ij = -F_ji, so on global steps mass moves without loss; what it brings along loses momentum by dt^2 alone.
TEST(SphsRun, ExchangedMassIsConservedToRounding) {
  const ParticleSet gas = unequal_gas(0);
  const auto run = make_simulation(gas, in_double());
  const double before = run->totals().mass;
  for (int step = 0; step < 10; ++step) run->step(1e9);
  EXPECT_NEAR(run->totals().mass, before, 1e-13 * before);
  const std::vector<double> m = run->snapshot().field("Masses").values;
  double moved = 0;
  for (std::size_t i = 0; i < m.size(); ++i) moved += std::abs(m[i] - gas.m[i]);
  EXPECT_GT(moved, 1e-4 * before) << "masses must have been exchanged at all";
}

/// Two runs of 5 steps, one in a box that moves at 20: velocities apart from the boost, masses and energies must agree
/// to the rounding of positions and velocities (1e-15 of 20, over steps that amplify it a little).
TEST(SphsRun, ABoostChangesNothingWithTheDonorsCorrection) {
  const Snapshot rest = after_steps(unequal_gas(0), in_double(), 5),
                 moving = after_steps(unequal_gas(20), in_double(), 5);
  EXPECT_LT(largest_difference(rest.field("InternalEnergies"), moving.field("InternalEnergies")), 1e-10);
  EXPECT_LT(largest_difference(rest.field("Masses"), moving.field("Masses")), 1e-12);
}

/// S12's own correction stops the particle that gains mass, in whatever frame that is (S12 eq 39).
TEST(SphsRun, ABoostChangesTheResultOfS12sCorrection) {
  SimulationSettings s = in_double();
  s.numbers.set("dissipation.mass_form", 3);  // particle
  const Snapshot rest = after_steps(unequal_gas(0), s, 5), moving = after_steps(unequal_gas(20), s, 5);
  EXPECT_GT(largest_difference(rest.field("InternalEnergies"), moving.field("InternalEnergies")), 1e-3);
}

/// Strengths of zero leave an adiabatic gas: the entropies stay as they were.
TEST(SphsRun, WithoutStrengthsThereIsNoDissipation) {
  SimulationSettings s = in_double();
  s.numbers = {{"viscosity.alpha", 0}, {"dissipation.entropy", 0}, {"dissipation.mass", 0}};
  const ParticleSet gas = unequal_gas(0);
  const auto run = make_simulation(gas, s);
  const Snapshot before = run->snapshot();
  for (int step = 0; step < 5; ++step) run->step(1e9);
  EXPECT_LT(largest_difference(run->snapshot().field("Entropies"), before.field("Entropies")), 1e-12);
}

/// A sound wave over a density step, with global steps and with steps of the particles' own: the same flow to second
/// order of the steps, at fewer updates.
TEST(SphsRun, OwnStepsFollowTheSameFlowWithFewerUpdates) {
  ParticleSet gas = shaken_lattice(3, {24, 6, 6}, 0.05, true, 9);
  gas.m.assign(gas.size(), gas.m[0]);
  for (std::size_t i = 0; i < gas.size(); ++i) {
    gas.u[i] = gas.x[i][0] < -0.1 ? 60 : 1;
    gas.v[i] = {0.05 * std::sin(8 * M_PI * gas.x[i][1]), 0, 0};
  }
  SimulationSettings s = in_double();
  const double end = 0.02;
  const auto evolve = [&](bool individual) {
    s.steps = individual ? own_steps : global_steps;
    auto run = make_simulation(gas, s);
    while (run->time() < end) run->step(end);
    return run;
  };
  const auto global = evolve(false), own = evolve(true);
  EXPECT_LT(own->costs().updates, 0.8 * static_cast<double>(global->costs().updates));
  const Snapshot a = global->snapshot(), b = own->snapshot();
  // 10 steps of C = 0.2 each move the gas by 2 h; second order leaves some C^2 of the change.
  double change = 0;
  for (const double v : a.field("Velocities").values) change = std::max(change, std::abs(v));
  EXPECT_LT(largest_difference(a.field("Velocities"), b.field("Velocities")), 0.05 * change);
}

/// In the midst of a block of steps another end is asked for: the run stops there, all particles in step.
TEST(SphsRun, OwnStepsEndWhereTheyAreToldTo) {
  SimulationSettings s = in_double();
  s.steps = own_steps;
  const auto run = make_simulation(unequal_gas(0), s);
  run->step(0.5);
  const double early = run->time() + 1e-3;
  while (run->time() < early) run->step(early);
  EXPECT_EQ(run->time(), early);
  const Snapshot end = run->snapshot();
  for (const double v : end.field("Velocities").values) ASSERT_TRUE(std::isfinite(v));
}

}  // namespace
}  // namespace sphk::test
