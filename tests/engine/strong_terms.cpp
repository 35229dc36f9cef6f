// SPDX-License-Identifier: BSD-3-Clause

// Terms that are stronger than usual, and steps that are too long for them: the time-step follows, or the run counts
// and says what it had to soften.
#include <gtest/gtest.h>

#include <algorithm>

#include "src/schemes/registry.hpp"
#include "tests/compiled_schemes.hpp"
#include "tests/engine/brute_force.hpp"

namespace sphk::test {
namespace {

struct Case {
  std::string name, scheme, key;
  double value, times_shorter;
};

class StrongTerm : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    if (!is_compiled(GetParam().scheme)) GTEST_SKIP();
  }
};

/// A dissipation 20 times as strong lets heat and momentum through 20 times as fast: its explicit steps must be as much
/// shorter. Weak ones do not make them longer.
TEST_P(StrongTerm, ShortensTheTimeStep) {
  const Case& c = GetParam();
  const ParticleSet gas = shaken_lattice(2, {12, 12, 1}, 0.2, true, 5);
  SimulationSettings usual{.scheme = c.scheme, .precision = "double", .steps = global_steps}, strong = usual;
  strong.numbers.set(c.key, c.value);
  const double dt = make_simulation(gas, usual)->step(1e9).dt, shorter = make_simulation(gas, strong)->step(1e9).dt;
  EXPECT_NEAR(dt / shorter, c.times_shorter, 1e-9 * c.times_shorter);
}

INSTANTIATE_TEST_SUITE_P(Numbers, StrongTerm,
                         testing::Values(Case{"viscosity", "gadget2", "viscosity.alpha", 20, 20},
                                         Case{"weak_viscosity", "gadget2", "viscosity.alpha", 0.1, 1},
                                         Case{"conductivity", "v10", "conductivity.alpha", 7, 7},
                                         Case{"quadratic_viscosity", "v10", "viscosity.beta", 12, 4},
                                         Case{"entropy", "sphs", "dissipation.entropy", 20, 20},
                                         Case{"mass", "sphs", "dissipation.mass", 10, 10},
                                         Case{"switched_viscosity", "sphs", "viscosity.alpha", 5, 5},
                                         Case{"one_alpha", "sphs", "switch.alpha", 3, 3}),
                         [](const auto& info) { return info.param.name; });

/// Between particles at rest that cannot move heat flows from the hot to the cold alone: none becomes hotter than the
/// hottest was, or colder than the coldest. Steps that are too long turn the flow around.
TEST(StrongTerms, OfHeatNeverOvershoot) {
  for (const auto& [scheme, key] : {std::pair("sphs", "dissipation.entropy"), std::pair("v10", "conductivity.alpha")}) {
    if (!is_compiled(scheme)) continue;
    ParticleSet gas = shaken_lattice(2, {16, 16, 1}, 0.2, true, 7);
    gas.m.assign(gas.size(), gas.m[0]);
    gas.v.assign(gas.size(), {});
    const auto [coldest, hottest] = std::ranges::minmax(gas.u);
    ASSERT_GT(hottest, 1.5 * coldest);
    SimulationSettings s{.scheme = scheme, .precision = "double", .steps = global_steps};
    s.numbers = {{key, 50}, {"time.motion", 0}};
    if (scheme == std::string("sphs")) s.numbers.set("switch.alpha", 1);
    const auto run = make_simulation(gas, s);
    for (int step = 0; step < 100; ++step) run->step(1e9);
    const std::vector<double> u = run->snapshot().field("InternalEnergies").values;
    EXPECT_LE(std::ranges::max(u), hottest * (1 + 1e-12)) << scheme;
    EXPECT_GE(std::ranges::min(u), coldest * (1 - 1e-12)) << scheme;
    EXPECT_LT(std::ranges::max(u) - std::ranges::min(u), 0.9 * (hottest - coldest)) << scheme << ": heat has flowed";
  }
}

/// Gas that flies apart within a step loses more heat than half of what it has: it stays warm, and the run says so.
TEST(SoftenedLosses, AreCountedAndTold) {
  ParticleSet gas = shaken_lattice(3, {6, 6, 6}, 0.1, false, 3);
  for (std::size_t i = 0; i < gas.size(); ++i)
    for (int d = 0; d < 3; ++d) gas.v[i][d] = 50 * (gas.x[i][d] - 0.5);
  SimulationSettings s{.scheme = "sph", .energy = "energy", .courant = 10};
  const auto hasty = make_simulation(gas, s);
  hasty->step(1e9);
  EXPECT_GT(hasty->counts().softened_heat, 0);
  EXPECT_EQ(hasty->counts().softened_mass, 0);
  for (const double u : hasty->snapshot().field("InternalEnergies").values) EXPECT_GE(u, 0);
  const auto warnings = hasty->warnings();
  EXPECT_TRUE(std::ranges::any_of(
      warnings, [](const std::string& text) { return text.find("more than half of a particle's heat") != text.npos; }));
  s.courant = 0.05;
  const auto careful = make_simulation(gas, s);
  careful->step(1e9);
  EXPECT_EQ(careful->counts().softened_heat, 0);
}

}  // namespace
}  // namespace sphk::test
