// SPDX-License-Identifier: BSD-3-Clause

// What the classic schemes conserve, and how well.
#include <gtest/gtest.h>

#include <cmath>

#include "src/schemes/registry.hpp"
#include "tests/compiled_schemes.hpp"
#include "tests/engine/brute_force.hpp"

namespace sphk::test {
namespace {

SimulationSettings in_double(const std::string& scheme) {
  SimulationSettings s;
  s.scheme = scheme;
  s.kernel = "cs";
  s.neighbours = 48;
  s.precision = "double";
  return s;
}

/// Sum of m |v|: the scale of the rounding of the momentum's sum.
double momentum_scale(const Snapshot& snapshot) {
  const auto &m = snapshot.field("Masses").values, &v = snapshot.field("Velocities").values;
  double sum = 0;
  for (std::size_t k = 0; k < v.size(); ++k) sum += m[k / 3] * std::abs(v[k]);
  return sum;
}

class Momentum : public testing::TestWithParam<const char*> {};

/// Every force has its exact opposite, so after some steps momentum has moved by roundings alone.
TEST_P(Momentum, IsConservedToRounding) {
  if (!is_compiled(GetParam())) GTEST_SKIP();
  const ParticleSet gas = shaken_lattice(3, {10, 9, 8}, 0.3, true, 3);
  const auto run = make_simulation(gas, in_double(GetParam()));
  const Totals before = run->totals();
  for (int step = 0; step < 20; ++step) run->step(1e9);
  const Totals after = run->totals();
  const double scale = momentum_scale(run->snapshot());
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(after.momentum[d], before.momentum[d], 1e-13 * scale) << "axis " << d;
  EXPECT_EQ(run->snapshot().field("Masses").values, gas.m) << "nothing changes a mass";
}
INSTANTIATE_TEST_SUITE_P(Schemes, Momentum, testing::Values("sph", "tsph", "gadget2", "osph", "osph-coherent", "v10"));

/// Open space: no wrapping and no walls, so angular momentum too.
TEST(AngularMomentum, IsConservedToTheIntegratorsRounding) {
  const ParticleSet gas = shaken_lattice(3, {8, 8, 8}, 0.3, false, 4);
  const auto run = make_simulation(gas, in_double("gadget2"));
  const Totals before = run->totals();
  for (int step = 0; step < 20; ++step) run->step(1e9);
  const Totals after = run->totals();
  const double scale = momentum_scale(run->snapshot());  // positions are of order one
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(after.angular_momentum[d], before.angular_momentum[d], 1e-13 * scale);
}

/// Energy of the conservative form, without viscosity, over a fixed time with fixed steps.
double energy_drift(double dt) {
  ParticleSet gas = shaken_lattice(3, {8, 8, 8}, 0.25, true, 5);
  for (Array3& v : gas.v)
    for (double& component : v) component *= 0.2;
  SimulationSettings s = in_double("gadget2");
  s.numbers.set("viscosity.alpha", 0);
  s.max_dt = dt;
  const auto run = make_simulation(gas, s);
  const double before = run->totals().energy();
  while (run->time() < 0.02) run->step(0.02);
  return (run->totals().energy() - before) / before;
}

/// Kick-drift-kick is of second order: a tenth of the step, a hundredth of the drift. The searches for h end at moves
/// of 3e-4, which set the floor.
TEST(Energy, DriftOfGadget2FallsWithTheSquareOfTheStep) {
  const double coarse = std::abs(energy_drift(1e-2)), fine = std::abs(energy_drift(1e-3));
  EXPECT_LT(coarse, 1e-5);
  EXPECT_LT(fine, coarse / 50) << coarse << " and " << fine;
}

struct EnergyForm : testing::TestWithParam<const char*> {};

/// The energy form (R10 eq 18) moves energy between motion and heat pair by pair, as the time-steps vanish: with all
/// dissipations and, for sphs, with mass that particles of unequal masses exchange.
TEST_P(EnergyForm, ConservesTheTotalToTheOrderOfTheStep) {
  ParticleSet gas = shaken_lattice(3, {8, 8, 8}, 0.25, true, 6);
  const auto drift = [&](double dt) {
    SimulationSettings s = in_double(GetParam());
    s.energy = "energy";
    s.max_dt = dt;
    const auto run = make_simulation(gas, s);
    const double before = run->totals().energy();
    while (run->time() < 0.02) run->step(0.02);
    return std::abs(run->totals().energy() - before) / before;
  };
  EXPECT_LT(drift(1e-3), 2e-3);
  EXPECT_LT(drift(5e-4), 0.6 * drift(1e-3));
}
INSTANTIATE_TEST_SUITE_P(Schemes, EnergyForm, testing::Values("sph", "sphs"));

}  // namespace
}  // namespace sphk::test
