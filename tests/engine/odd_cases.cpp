// SPDX-License-Identifier: BSD-3-Clause

// Arrangements that break codes: the result is finite and right, or the error is a sentence.
#include <gtest/gtest.h>

#include <cmath>

#include "src/engine/errors.hpp"
#include "src/schemes/registry.hpp"
#include "tests/engine/brute_force.hpp"

namespace sphk::test {
namespace {

SimulationSettings settings_for(double neighbours) {
  SimulationSettings s;
  s.scheme = "gadget2";
  s.kernel = "cs";
  s.neighbours = neighbours;
  s.precision = "double";
  return s;
}

ParticleSet gas_at(std::vector<Array3> places, int dimension = 3, bool periodic = false) {
  ParticleSet gas;
  gas.dimension = dimension;
  for (int d = 0; d < dimension; ++d) gas.box.periodic[d] = periodic;
  gas.v.assign(places.size(), {});
  gas.m.assign(places.size(), 1.0 / double(places.size()));
  gas.u.assign(places.size(), 1.0);
  gas.x = std::move(places);
  return gas;
}

/// Runs a few steps; every number of the end state is finite and energies stay positive.
void expect_finite_run(const ParticleSet& gas, const SimulationSettings& settings) {
  const auto run = make_simulation(gas, settings);
  for (int step = 0; step < 5; ++step) run->step(run->time() + 1e-3);
  const Snapshot end = run->snapshot();
  ASSERT_EQ(end.size(), gas.size());
  for (const Field& field : end.fields)
    for (const double value : field.values) ASSERT_TRUE(std::isfinite(value)) << field.name;
  for (const double u : end.field("InternalEnergies").values) ASSERT_GE(u, 0);
}

std::string message_of(const ParticleSet& gas, const SimulationSettings& settings) {
  try {
    make_simulation(gas, settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(OddCases, OneParticleStaysWhereItIs) {
  const auto run = make_simulation(gas_at({{0.5, 0.5, 0.5}}), settings_for(48));
  run->step(0.1);
  const Snapshot end = run->snapshot();
  EXPECT_EQ(end.field("Coordinates").values, (std::vector<double>{0.5, 0.5, 0.5}));
  EXPECT_FALSE(run->warnings().empty()) << "it cannot have 48 neighbours, and the user is told";
}

TEST(OddCases, OneParticleInAPeriodicBoxSeesItsImages) {
  const auto run = make_simulation(gas_at({{0.2, 0.7, 0.1}}, 3, true), settings_for(48));
  // A cubic lattice of spacing 1 and mass 1: the density of V h^3 n = 48 is 1 to the kernel's sampling error.
  EXPECT_NEAR(run->snapshot().field("Densities").values[0], 1.0, 0.01);
  expect_finite_run(gas_at({{0.2, 0.7, 0.1}}, 3, true), settings_for(48));
}

TEST(OddCases, TwoParticlesFarApart) {
  expect_finite_run(gas_at({{0, 0, 0}, {1e6, 0, 0}}), settings_for(48));
}

TEST(OddCases, CoincidentParticlesFeelNoForceFromEachOther) {
  ParticleSet gas = shaken_lattice(3, {6, 6, 6}, 0.2, true, 1);
  gas.x[1] = gas.x[0];
  for (int k = 10; k < 20; ++k) gas.x[k] = gas.x[10];
  expect_finite_run(gas, settings_for(48));
  const auto warnings = make_simulation(gas, settings_for(48))->warnings();
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("coincident"), std::string::npos);
}

TEST(OddCases, AllParticlesAtOnePoint) {
  expect_finite_run(gas_at(std::vector<Array3>(100, {0.5, 0.5, 0.5})), settings_for(48));
}

TEST(OddCases, AllOnALineAndAllInAPlane) {
  std::vector<Array3> line, plane;
  for (int k = 0; k < 200; ++k) line.push_back({k / 200.0, 0.5, 0.5});
  for (int k = 0; k < 400; ++k) plane.push_back({k % 20 / 20.0, k / 20 / 20.0, 0.5});
  expect_finite_run(gas_at(line), settings_for(32));
  expect_finite_run(gas_at(plane), settings_for(32));
}

TEST(OddCases, ABoxOfAThousandToOneToOne) {
  ParticleSet gas = shaken_lattice(3, {1000, 1, 1}, 0.2, true, 2);
  const BruteForce wanted(gas, settings_for(48));
  const auto run = make_simulation(gas, settings_for(48));
  const auto rho = run->snapshot().field("Densities").values;
  for (std::size_t i = 0; i < rho.size(); ++i) ASSERT_NEAR(rho[i], wanted.rho[i], 1e-9 * wanted.rho[i]);
}

TEST(OddCases, ErrorsNameTheParticleAndTheRemedy) {
  ParticleSet gas = shaken_lattice(3, {4, 4, 4}, 0.2, true, 2);
  EXPECT_NE(message_of(gas_at({}), settings_for(48)).find("no gas particles"), std::string::npos);
  gas.m[5] = -1;
  EXPECT_NE(message_of(gas, settings_for(48)).find("particle 5 (id 6)"), std::string::npos);
  gas.m[5] = 1;
  gas.x[7][2] = std::nan("");
  EXPECT_NE(message_of(gas, settings_for(48)).find("particle 7 (id 8)"), std::string::npos);
  gas.x[7][2] = 0;
  EXPECT_NE(message_of(gas, settings_for(10)).find("the particle itself"), std::string::npos);
}

TEST(OddCases, ATimeStepThatVanishesNamesTheParticleAndTheRemedy) {
  ParticleSet gas = gas_at({{0.5, 0.5, 0.5}, {0.6, 0.5, 0.5}});
  gas.id = {70, 30};
  gas.time = 1;
  gas.u[1] = 1e40;  // C h / c is below 1e-20, and 1 + 1e-20 = 1
  const auto message = [&](bool individual) -> std::string {
    SimulationSettings settings = settings_for(48);
    settings.steps = individual ? own_steps : global_steps;
    try {
      make_simulation(gas, settings)->step(2);
    } catch (const NumericsError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_NE(message(false).find("too short to change the time"), std::string::npos) << message(false);
  EXPECT_NE(message(false).find("step 0, t = 1: the particle with id "), std::string::npos) << message(false);
  EXPECT_NE(message(true).find("below the shortest one"), std::string::npos) << message(true);
  gas.v[0][0] = 1e200;  // its square is no number
  EXPECT_NE(message(false).find("not a positive number"), std::string::npos) << message(false);
  EXPECT_NE(message(false).find("sph.precision"), std::string::npos) << message(false);
}

}  // namespace
}  // namespace sphk::test
