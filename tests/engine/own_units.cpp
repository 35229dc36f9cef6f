// SPDX-License-Identifier: BSD-3-Clause

// No result hangs on the user's units, nor on the first guesses that come with the particles.
#include <gtest/gtest.h>

#include <cmath>

#include "src/engine/errors.hpp"
#include "src/engine/scaled_simulation.hpp"
#include "src/engine/step_errors.hpp"
#include "src/schemes/compiled_rows.hpp"
#include "src/schemes/registry.hpp"
#include "tests/engine/brute_force.hpp"
#include "tests/engine/units.hpp"

namespace sphk::test {
namespace {

/// Some steps of every compiled scheme and form, by what the rows of their table ask for.
class OwnUnits : public testing::Test {
 protected:
  struct Run {
    SimulationSettings settings;
    int dimension;
    std::string name() const { return settings.scheme + " " + settings.energy + " " + settings.precision; }
  };
  static std::vector<Run> runs(int dimension) {
    std::vector<Run> all;
    for (const Instantiation& row : compiled_rows()) {
      if (row.dimension != dimension || row.kernel || !row.complete || row.scheme->hidden) continue;
      SimulationSettings s{.scheme = row.scheme->name, .kernel = "wc2", .precision = row.precision};
      s.energy = row.energy;
      s.neighbours = dimension == 2 ? 24 : 60;
      const bool known = std::ranges::any_of(
          all, [&](const Run& run) { return run.name() == s.scheme + " " + s.energy + " " + s.precision; });
      if (!known) all.push_back({s, dimension});
    }
    return all;
  }
  static Snapshot after_steps(const ParticleSet& gas, const SimulationSettings& settings, double time_unit) {
    const auto run = make_simulation(gas, settings);
    for (int step = 0; step < 3; ++step) run->step(1e3 * time_unit);
    return run->snapshot();
  }
};

const ParticleSet gas = [] {
  ParticleSet unequal = shaken_lattice(2, {14, 12, 1}, 0.3, true, 5);
  for (std::size_t i = 0; i < unequal.size(); ++i) unequal.m[i] *= i % 2 ? 1.5 : 1;
  return unequal;
}();

TEST_F(OwnUnits, PowersOfTwoChangeNoBit) {
  const Units units{0x1p100, 0x1p-61, 0x1p40};
  for (const Run& run : runs(2)) {
    const Snapshot one = after_steps(gas, run.settings, 1),
                   other = after_steps(in_units(gas, units), run.settings, units.time);
    EXPECT_EQ(other.time, one.time * units.time) << run.name();
    for (const char* name :
         {"Coordinates", "Velocities", "Masses", "Densities", "InternalEnergies", "SmoothingLength"}) {
      const Field &a = one.field(name), &b = other.field(name);
      const double in = factor(a.units, units);
      for (std::size_t k = 0; k < a.values.size(); ++k)
        ASSERT_EQ(b.values[k], a.values[k] * in) << run.name() << " " << name << " " << k;
    }
  }
}

TEST_F(OwnUnits, AnyUnitsGiveTheSameRunToRoundOff) {
  for (const Units& units : {Units{1e30, 1e-30, 1e10}, Units{1e-30, 1e30, 1e30}, Units{1e12, 1e25, 1e-7}})
    for (const Run& run : runs(2)) {
      const Snapshot one = after_steps(gas, run.settings, 1),
                     other = after_steps(in_units(gas, units), run.settings, units.time);
      const double bound = run.settings.precision == "double" ? 1e-10 : 1e-4;
      for (const Field& a : one.fields) {
        const Field& b = other.field(a.name);
        const double in = factor(a.units, units);
        double scale = 0;
        for (const double value : a.values) scale = std::max(scale, std::abs(value));
        for (std::size_t k = 0; k < a.values.size(); ++k)
          ASSERT_NEAR(b.values[k] / in, a.values[k], bound * scale) << run.name() << " " << a.name << " " << k;
      }
    }
}

TEST_F(OwnUnits, TotalsAndErrorsAreInTheUsersUnits) {
  const Units units{1e20, 1e-3, 1e15};
  const SimulationSettings s{.scheme = "sph", .kernel = "wc2", .precision = "double", .neighbours = 24};
  const auto one = make_simulation(gas, s), other = make_simulation(in_units(gas, units), s);
  const Totals a = one->totals(), b = other->totals();
  const double energy = units.mass * std::pow(units.length / units.time, 2);
  EXPECT_NEAR(b.mass / units.mass, a.mass, 1e-12 * a.mass);
  EXPECT_NEAR(b.thermal / energy, a.thermal, 1e-12 * a.thermal);
  EXPECT_NEAR(b.kinetic / energy, a.kinetic, 1e-12 * a.kinetic);
  EXPECT_NEAR(b.max_speed * units.time / units.length, a.max_speed, 1e-12 * a.max_speed);
  EXPECT_NEAR(b.max_density * std::pow(units.length, 2) / units.mass, a.max_density, 1e-11 * a.max_density);
  EXPECT_NEAR(b.max_pressure / energy * std::pow(units.length, 2), a.max_pressure, 1e-11 * a.max_pressure);
  EXPECT_NEAR(b.max_entropy / factor(one->snapshot().field("Entropies").units, units), a.max_entropy,
              1e-10 * a.max_entropy);
  EXPECT_NEAR(b.angular_momentum[2] / (units.mass * std::pow(units.length, 2) / units.time), a.angular_momentum[2],
              1e-10 * std::abs(a.angular_momentum[2]) + 1e-14);
  const auto rates_a = one->rates(true), rates_b = other->rates(true);
  ASSERT_EQ(rates_a.size(), rates_b.size());
  for (std::size_t f = 0; f < rates_a.size(); ++f) {
    double scale = 1e-12;
    for (const double value : rates_a[f].values) scale = std::max(scale, std::abs(value));
    for (std::size_t k = 0; k < rates_a[f].values.size(); ++k)
      ASSERT_NEAR(rates_b[f].values[k] / factor(rates_a[f].units, units), rates_a[f].values[k], 1e-8 * scale)
          << rates_a[f].name;
  }
}

TEST_F(OwnUnits, AStateGoesOnInTheUnitsThatItHad) {
  SimulationSettings s{.scheme = "sph", .kernel = "wc2", .neighbours = 24};
  const auto run = make_simulation(gas, s);
  run->step(1e3);
  const SavedState saved = run->save();
  ParticleSet stretched = gas;
  for (Array3& v : stretched.v) v[0] *= 100;  // its own units would be others
  s.own_units = scale_of([&](const std::string& name) { return saved.at(name); });
  const auto resumed = make_simulation(stretched, s);
  resumed->restore(saved);
  EXPECT_EQ(resumed->snapshot().field("Coordinates").values, run->snapshot().field("Coordinates").values);
  s.own_units.reset();
  EXPECT_THROW(make_simulation(stretched, s)->restore(saved), InputError);
}

TEST_F(OwnUnits, GivenSupportsDecideNothing) {
  const SimulationSettings s{.scheme = "sph", .kernel = "wc2", .precision = "double", .neighbours = 24};
  const Snapshot found = make_simulation(gas, s)->snapshot();
  for (const double h : {0.0, 1e-300, 1e-3, 10.0, 1e20, 1e300}) {
    ParticleSet guessed = gas;
    guessed.h.assign(gas.size(), h);
    const Snapshot snapshot = make_simulation(guessed, s)->snapshot();
    for (const char* name : {"SmoothingLength", "Densities"})
      EXPECT_EQ(snapshot.field(name).values, found.field(name).values) << h;
  }
}

/// A cube with one more particle, which is in a cell with some of the cube's.
ParticleSet cube_and_one(const Array3& x, const Array3& v, double box) {
  ParticleSet cube = shaken_lattice(3, {12, 12, 12}, 0.3, false, 7);
  cube.x.push_back(x);
  cube.v.push_back(v);
  cube.m.push_back(cube.m[0]);
  cube.u.push_back(cube.u[0]);
  if (!cube.id.empty()) cube.id.push_back(99999);
  cube.box.size = {box, box, box};
  return cube;
}

/// Mixed pair arithmetic kicks the particles of a cube as double does, whatever the odd one in a cell of theirs is
/// like.
void expect_exact_kicks(const ParticleSet& gas, double h_max) {
  SimulationSettings s{.scheme = "gadget2", .kernel = "cs", .precision = "double", .neighbours = 48, .h_max = h_max};
  const auto kicks = [&] {
    const auto run = make_simulation(gas, s);
    const double dt = run->step(1e-9).dt;
    std::vector<double> kick = run->snapshot().field("Velocities").values;
    for (std::size_t i = 0; i < gas.size(); ++i)
      for (std::size_t d = 0; d < 3; ++d) kick[3 * i + d] = (kick[3 * i + d] - gas.v[i][d]) / dt;
    kick.resize(3 * (gas.size() - 1));  // of a fast particle round-off alone is left
    return kick;
  };
  const std::vector<double> exact = kicks();
  s.precision = "mixed";
  const std::vector<double> mixed = kicks();
  double largest = 0;
  for (const double a : exact) largest = std::max(largest, std::abs(a));
  for (std::size_t k = 0; k < exact.size(); ++k) ASSERT_NEAR(mixed[k], exact[k], 1e-5 * largest) << k;
}

TEST_F(OwnUnits, AParticleFarAwayDoesNotSpoilThoseOfItsCell) {
  expect_exact_kicks(cube_and_one({1e6, 1e6, 1e6}, {0, 0, 0}, 2e6), 0);
}

/// It is beside the cube, out of reach of the others and they of it.
TEST_F(OwnUnits, AVeryFastParticleDoesNotSpoilThoseOfItsCell) {
  for (const double corner : {1.4, -0.4})  // behind the last of its cell, and before the first
    expect_exact_kicks(cube_and_one({corner, corner, corner}, {1e8, -1e8, 1e8}, 4), 0.3);
}

/// A mass that no float holds ends the run before its first step: the particle is told where the user has it.
TEST_F(OwnUnits, WhatFailsAtTheStartIsToldInTheUsersUnits) {
  ParticleSet gas = shaken_lattice(3, {8, 8, 8}, 0.2, true, 7);
  for (Array3& x : gas.x)
    for (double& component : x) component *= 0x1p40;
  gas.box.size = {0x1p40, 0x1p40, 0x1p40};
  gas.m[100] *= 1e60;
  try {
    make_simulation(gas, {.scheme = "gadget2"});
    FAIL() << "it cannot be computed";
  } catch (const StuckError& error) {
    EXPECT_EQ(error.particle.x, gas.x[error.particle.id - 1]);
    EXPECT_EQ(error.reason, StuckReason::not_finite);
  }
}

/// osph measures densities by entropies, and entropies follow from the energies given.
TEST_F(OwnUnits, EveryFormStartsFromTheEnergiesGiven) {
  ParticleSet uneven = gas;
  for (std::size_t i = 0; i < uneven.size(); ++i) uneven.u[i] *= i % 3 == 0 ? 30 : 1;
  for (const Run& run : runs(2)) {
    const auto simulation = make_simulation(uneven, run.settings);
    const Field u = simulation->snapshot().field("InternalEnergies");
    const double bound = run.settings.precision == "double" ? 1e-10 : 1e-6;
    for (std::size_t i = 0; i < uneven.size(); ++i)
      ASSERT_NEAR(u.values[i], uneven.u[i], bound * uneven.u[i]) << run.name() << " " << i;
    const double before = simulation->totals().energy();
    simulation->heat({0.4, 0.4, 0}, 0.5 * before);
    EXPECT_NEAR(simulation->totals().energy(), 1.5 * before, 1e-6 * before) << run.name();
  }
}

}  // namespace
}  // namespace sphk::test
