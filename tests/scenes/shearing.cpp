// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/scenes/initial_condition.hpp"
#include "src/schemes/registry.hpp"
#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

using Keys = std::vector<std::pair<std::string, std::string>>;

Settings settings_with(const Keys& keys) {
  Settings settings;
  declare_engine_keys(settings);
  declare_initial_condition_keys(settings);
  settings.declare({.name = "time.end", .value = 1.0, .doc = "", .choices = {}});
  shearing_scene.declare(settings);
  for (const auto& [name, text] : keys) settings.set_from_text(name, text, Origin::command_line);
  shearing_scene.adapt(settings);
  adopt_scheme(settings, 2, shearing_scene.mixes());
  return settings;
}

/// Lowest and highest pressure of a run at its end.
std::pair<double, double> pressures_after(const Settings& settings, double end) {
  const auto run = make_simulation(initial_condition(shearing_scene, settings), simulation_settings(settings));
  while (run->time() < end) run->step(end);
  const Totals totals = run->totals();
  return {totals.min_pressure, totals.max_pressure};
}

// V10 Table 4: 199252 particles on two grids, 184100 on columns, 551100 of LIQ+ (to 1 %), 200788 with rows between the
// grids (to 1 %).
TEST(Shearing, CountsAreV10s) {
  const auto count = [](const char* series) {
    Settings settings = settings_of(shearing_scene, {{"scene.series", series}});
    return double(shearing_scene.build(settings).size());
  };
  EXPECT_NEAR(count("SPH"), 199252, 0.002 * 199252);
  EXPECT_EQ(count("LIQ"), 184100);
  EXPECT_EQ(count("RHO"), 184100);
  EXPECT_NEAR(count("GRID"), 200788, 0.01 * 200788);
  EXPECT_NEAR(count("LIQ+"), 551100, 0.01 * 551100);
}

TEST(Shearing, SeriesChooseWhatIsNotSet) {
  const Settings noac = settings_with({{"scene.series", "NOAC"}});
  EXPECT_EQ(noac.text("sph.scheme"), "v10");
  EXPECT_EQ(noac.text("sph.kernel"), "liq");
  EXPECT_EQ(noac.real("conductivity.alpha"), 0);
  EXPECT_EQ(noac.real("sph.neighbours"), 32);
  const Settings own = settings_with({{"scene.series", "SPH"}, {"sph.kernel", "wc4"}, {"scene.smoothing", "rows"}});
  EXPECT_EQ(own.text("sph.kernel"), "wc4");
  EXPECT_EQ(own.text("scene.smoothing"), "rows");
}

// Speeds of Mach 0.5 of the dense gas, c = sqrt(5/3) with P/rho = 1; u = 15 and 1.5 far from the boundaries; V10 eq 15
// everywhere, or near the interfaces alone.
TEST(Shearing, FlowIsV10s) {
  const double speed = 0.5 * std::sqrt(5.0 / 3);
  for (const double reach : {0.0, 0.025}) {
    const ParticleSet gas =
        shearing_scene.build(settings_of(shearing_scene, {{"scene.n", "40"},
                                                          {"scene.mach", "0.5"},
                                                          {"scene.seed_reach", std::to_string(reach)},
                                                          {"sph.gamma", "1.66666666666666667"}}));
    for (std::size_t i = 0; i < gas.size(); ++i) {
      const double inwards = 0.25 - std::abs(gas.x[i][1] - 0.5);
      ASSERT_NEAR(gas.v[i][0], inwards > 0 ? speed : -speed, 1e-12);
      const bool seeded = reach == 0 || std::abs(inwards) < reach;
      ASSERT_NEAR(gas.v[i][1], seeded ? 0.025 * std::sin(12 * M_PI * gas.x[i][0]) : 0, 1e-12);
      if (std::abs(inwards) > 0.04) {
        ASSERT_NEAR(gas.u[i], inwards > 0 ? 1.5 : 15, 1e-9);
      }
    }
  }
}

// V10 Fig. 1: of fixed particles at one pressure, Price's conductivity amplifies the rounding of that pressure, because
// the light gas is hotter whatever the signs of pressure differences are; V10's first signal velocity takes heat from
// the higher pressure, so that nothing grows.
TEST(Shearing, FixedParticlesKeepTheirPressureWithV10sSignalVelocityAlone) {
  const auto spread = [](const char* signal) {
    const auto [low, high] = pressures_after(settings_with({{"scene.series", "RHO"},
                                                            {"scene.n", "20"},
                                                            {"scene.mach", "0"},
                                                            {"scene.seed", "0"},
                                                            {"time.motion", "false"},
                                                            {"sph.precision", "double"},
                                                            {"conductivity.signal", signal}}),
                                             0.5);
    return (high - low) / 10;
  };
  EXPECT_GT(spread("price"), 0.3);
  EXPECT_LT(spread("v1"), 0.003);
}

// Relaxation: u changes by dissipation alone, so without any it stays, to rounding, while particles move; and
// velocities are those of the places where they came to rest.
TEST(InitialCondition, RelaxesWithoutWork) {
  const Keys keys{{"scene.series", "RHO"}, {"scene.n", "24"}, {"viscosity.alpha", "0"}, {"conductivity.alpha", "0"}};
  Keys relaxed = keys;
  relaxed.emplace_back("ic.relax", "0.1");
  const ParticleSet before = initial_condition(shearing_scene, settings_with(keys));
  const ParticleSet after = initial_condition(shearing_scene, settings_with(relaxed));
  double moved = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    moved = std::max(moved, std::abs(after.x[i][1] - before.x[i][1]));
    const double y = after.x[i][1], inwards = 0.25 - std::abs(y - 0.5);
    ASSERT_GT(after.v[i][0] * inwards, 0) << "velocity of the layer at y = " << y;
  }
  EXPECT_GT(moved, 1e-4);
  EXPECT_EQ(after.m, before.m);
  for (std::size_t i = 0; i < before.size(); ++i) ASSERT_NEAR(after.u[i], before.u[i], 1e-14 * before.u[i]);
}

TEST(InitialCondition, TakesEveryEnergyFromAPressure) {
  const auto [low, high] = pressures_after(
      settings_with(
          {{"scene.n", "20"}, {"scene.temperatures", "exact"}, {"ic.pressure", "3"}, {"sph.precision", "double"}}),
      0);
  EXPECT_NEAR(low, 3, 1e-6);
  EXPECT_NEAR(high, 3, 1e-6);
}

// After each of several rounds u follows from the pressure again; after one it keeps what settling has left.
TEST(InitialCondition, SettlesWithEvenPressureInRounds) {
  const auto spread = [](const char* rounds) {
    const auto [low, high] = pressures_after(settings_with({{"scene.n", "20"},
                                                            {"scene.temperatures", "exact"},
                                                            {"ic.pressure", "3"},
                                                            {"ic.relax", "0.1"},
                                                            {"ic.rounds", rounds},
                                                            {"sph.precision", "double"}}),
                                             0);
    return std::max(std::abs(low - 3), std::abs(high - 3));
  };
  EXPECT_GT(spread("1"), 1e-3);
  EXPECT_LT(spread("3"), 1e-6);
}

}  // namespace
}  // namespace sphk
