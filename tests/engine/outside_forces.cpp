// SPDX-License-Identifier: BSD-3-Clause

// What acts on the gas beside its own pairs: a central mass, and heat in mid-run.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "src/engine/errors.hpp"
#include "src/schemes/registry.hpp"
#include "tests/engine/brute_force.hpp"

namespace sphk::test {
namespace {

constexpr double GM = 2, softening = 0.3;

/// A particle without pressure on an eccentric orbit around the central mass.
ParticleSet one_in_orbit(int dimension) {
  ParticleSet gas;
  gas.dimension = dimension;
  gas.box = {{-4, -4, -4}, {8, 8, 8}, {}};
  gas.x = {{1.5, 0, 0}};
  gas.v = {{0, 0.8, 0}};
  gas.m = {0.7};
  gas.u = {0};
  return gas;
}

SimulationSettings orbit_settings(double courant) {
  SimulationSettings s;
  s.scheme = "gadget2";
  s.precision = "double";
  s.neighbours = 12;
  s.courant = courant;
  s.numbers = {{"gravity.central_mass", GM}, {"gravity.softening", softening}};
  return s;
}

Array3 place_after(double courant, double time, int dimension) {
  const auto run = make_simulation(one_in_orbit(dimension), orbit_settings(courant));
  while (run->time() < time) run->step(time);
  const auto x = run->snapshot().field("Coordinates").values;
  return {x[0], x[1], x[2]};
}

/// The same orbit by the classic Runge-Kutta method.
Array3 exact_place(double time) {
  using State = std::array<double, 4>;
  const auto rate = [](const State& s) {
    const double k = -GM / std::pow(s[0] * s[0] + s[1] * s[1] + softening * softening, 1.5);
    return State{s[2], s[3], k * s[0], k * s[1]};
  };
  const auto along = [](const State& s, const State& d, double t) {
    State sum = s;
    for (int i = 0; i < 4; ++i) sum[i] += t * d[i];
    return sum;
  };
  State s{1.5, 0, 0, 0.8};
  constexpr int steps = 20000;
  const double dt = time / steps;
  for (int k = 0; k < steps; ++k) {
    const State a = rate(s), b = rate(along(s, a, dt / 2)), c = rate(along(s, b, dt / 2)), d = rate(along(s, c, dt));
    for (int i = 0; i < 4; ++i) s[i] += dt / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
  }
  return {s[0], s[1], 0};
}

TEST(CentralMass, OrbitIsTheExactOneToSecondOrder) {
  const Array3 exact = exact_place(5);
  for (const int D : {2, 3}) {
    double errors[2];
    for (const int half : {0, 1}) {
      const Array3 x = place_after(half ? 0.01 : 0.02, 5, D);
      errors[half] = std::hypot(x[0] - exact[0], x[1] - exact[1], x[2] - exact[2]);
    }
    EXPECT_LT(errors[0], 0.01) << D;
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.3) << D;
  }
}

TEST(CentralMass, EnergyHasItsPotential) {
  const auto run = make_simulation(one_in_orbit(2), orbit_settings(0.01));
  const Totals start = run->totals();
  EXPECT_NEAR(start.potential, -0.7 * GM / std::sqrt(1.5 * 1.5 + softening * softening), 1e-14);
  EXPECT_NEAR(start.energy(), start.potential + 0.5 * 0.7 * 0.64, 1e-14);
  while (run->time() < 5) run->step(5);
  EXPECT_NEAR(run->totals().energy(), start.energy(), 1e-4 * std::abs(start.energy()));
  EXPECT_NEAR(run->totals().angular_momentum[2], start.angular_momentum[2], 1e-12);
}

TEST(CentralMass, PeriodicBoxesAreRefused) {
  ParticleSet gas = one_in_orbit(2);
  gas.box.periodic[1] = true;
  try {
    make_simulation(gas, orbit_settings(0.1));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("periodic along y"), std::string::npos) << error.what();
  }
}

/// Cold gas whose particles may take long steps.
struct ColdGas {
  ParticleSet particles = shaken_lattice(3, {8, 8, 8}, 0.1, true, 3);
  SimulationSettings settings;
  explicit ColdGas(bool individual) {
    for (double& u : particles.u) u = 1e-4;
    for (Array3& v : particles.v) v = {};
    settings.scheme = "gadget2";
    settings.precision = "double";
    settings.neighbours = 40;
    settings.steps = individual ? own_steps : global_steps;
  }
};

TEST(Heat, ComesToTheNearestParticleAlone) {
  for (const bool individual : {false, true}) {
    ColdGas cold(individual);
    const auto run = make_simulation(cold.particles, cold.settings);
    for (int k = 0; k < 3; ++k) run->step(50);
    const Snapshot before = run->snapshot();
    const double energy = run->totals().energy();
    const auto& x = before.field("Coordinates").values;
    const std::size_t chosen = 77;
    run->heat({x[3 * chosen] + 1e-3, x[3 * chosen + 1], x[3 * chosen + 2]}, 0.25);
    EXPECT_NEAR(run->totals().energy(), energy + 0.25, 1e-7);  // supports, so densities, are searched anew
    EXPECT_EQ(run->totals().heated, 0.25);
    const auto &u = before.field("InternalEnergies").values, &m = before.field("Masses").values;
    const auto hot = run->snapshot().field("InternalEnergies").values;
    for (std::size_t i = 0; i < hot.size(); ++i)
      EXPECT_NEAR(hot[i], u[i] + (i == chosen ? 0.25 / m[i] : 0), 1e-7 * hot[i]) << i;
  }
}

// Particle i of the run's own order gains i of velocity along y and 0.5 of specific energy, whatever its id.
TEST(Gains, ComeToTheParticlesOfTheRunsOrder) {
  for (const bool individual : {false, true}) {
    ColdGas cold(individual);
    const auto run = make_simulation(cold.particles, cold.settings);
    for (int k = 0; k < 3; ++k) run->step(50);
    const Snapshot before = run->snapshot();
    const double energy = run->totals().energy();
    const std::vector<std::uint64_t> ids = run->held().id;
    Gains gains{std::vector<double>(3 * ids.size()), std::vector<double>(ids.size(), 0.5)};
    for (std::size_t i = 0; i < ids.size(); ++i) gains.velocity[3 * i + 1] = static_cast<double>(i);
    run->add(gains);
    const Snapshot after = run->snapshot();
    const auto &v = before.field("Velocities").values, &u = before.field("InternalEnergies").values;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const std::size_t row = ids[i] - 1;
      EXPECT_NEAR(after.field("Velocities").values[3 * row + 1], v[3 * row + 1] + static_cast<double>(i), 1e-9);
      EXPECT_NEAR(after.field("InternalEnergies").values[row], u[row] + 0.5, 1e-7);
    }
    EXPECT_NEAR(run->totals().heated, run->totals().energy() - energy, 1e-6 * run->totals().energy());
  }
}

TEST(Gains, ThatNobodyCanTakeAreRefused) {
  ColdGas cold(false);
  const auto run = make_simulation(cold.particles, cold.settings);
  EXPECT_THROW(run->add({{1, 2, 3}, {}}), InputError);
  EXPECT_THROW(run->add({{}, std::vector<double>(cold.particles.size(), -1)}), NumericsError);
  run->step(50);  // it goes on as if nothing had been asked
}

// What a run holds is what its snapshot shows, in another order and in the run's own units.
TEST(Held, ShowsTheStateWithoutACopy) {
  ColdGas cold(false);
  const auto run = make_simulation(cold.particles, cold.settings);
  run->step(50);
  const HeldParticles held = run->held(), again = run->held();
  const Snapshot snapshot = run->snapshot();
  ASSERT_EQ(held.fields.size(), again.fields.size());
  for (std::size_t f = 0; f < held.fields.size(); ++f) {
    const HeldField& field = held.fields[f];
    EXPECT_EQ(field.data, again.fields[f].data);
    const auto& shown = snapshot.field(field.name);
    if (field.components != shown.components) continue;
    for (std::size_t i = 0; i < held.id.size(); ++i)
      for (int k = 0; k < field.components; ++k) {
        const double own = field.data[static_cast<std::size_t>(k) * field.stride + i] * field.factor;
        EXPECT_DOUBLE_EQ(
            own,
            shown.values[(held.id[i] - 1) * static_cast<std::size_t>(field.components) + static_cast<std::size_t>(k)]);
      }
  }
}

TEST(Heat, AcrossAPeriodicFace) {
  ColdGas cold(false);
  cold.particles.x[5] = {0.999, 0.5, 0.5};
  const auto run = make_simulation(cold.particles, cold.settings);
  run->heat({0.0005, 0.5, 0.5}, 1);
  const auto u = run->snapshot().field("InternalEnergies").values;
  EXPECT_GT(u[5], 1);
}

// A particle heated by 5e8 in the midst of its long step: everyone's step ends there, the next one is what the hot
// particle asks for, its neighbours take that with it, those far away sleep, and the blast keeps its energy and stays
// in balance.
TEST(Heat, WakesTheNeighboursAtOnce) {
  ColdGas cold(true);
  const auto run = make_simulation(cold.particles, cold.settings);
  const double end = 50;
  double before = 0;
  for (int k = 0; k < 5; ++k) before = run->step(end).dt;
  ASSERT_LT(run->time(), end) << "in the midst of a block";
  run->heat({0.5, 0.5, 0.5}, 100);  // u from 1e-4 to 5e4
  const double energy = run->totals().energy();
  const StepReport first = run->step(end);
  EXPECT_LT(first.dt, 1e-3 * before);
  EXPECT_GT(static_cast<double>(first.updates), cold.settings.neighbours);
  EXPECT_LT(first.updates, static_cast<long>(run->size()));
  const double shortest = first.dt, until = run->time() + 0.002;
  while (run->time() < until) run->step(until);
  EXPECT_NEAR(run->totals().energy(), energy, 0.01 * energy);
  for (const double p : run->totals().momentum) EXPECT_NEAR(p, 0, 1e-3 * std::sqrt(2 * energy));
  EXPECT_GT(run->last_step().dt, shortest) << "steps grow again as the blast cools";
}

TEST(Heat, IsKeptByASavedRun) {
  ColdGas cold(true);
  const auto run = make_simulation(cold.particles, cold.settings);
  run->step(50);
  run->heat({0.5, 0.5, 0.5}, 1);
  run->step(50);
  const auto other = make_simulation(cold.particles, cold.settings);
  other->restore(run->save());
  for (int k = 0; k < 5; ++k) run->step(50), other->step(50);
  EXPECT_EQ(run->snapshot().field("Coordinates").values, other->snapshot().field("Coordinates").values);
  EXPECT_EQ(other->totals().heated, 1);
}

}  // namespace
}  // namespace sphk::test
