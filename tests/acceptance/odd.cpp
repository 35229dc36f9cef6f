// SPDX-License-Identifier: BSD-3-Clause

// Arrangements that break codes, from the scene `odd`: runs go on to their end, with sound numbers, and conserve.
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "src/scenes/scene.hpp"
#include "src/schemes/registry.hpp"
#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

SimulationSettings settings_for(const std::string& scheme, bool individual) {
  const bool sphs = scheme == "sphs";
  return {.scheme = scheme,
          .kernel = sphs ? "hoct4" : "cs",
          .neighbours = sphs ? 442.0 : 48.0,
          .courant = 0.2,
          .steps = individual ? own_steps : global_steps};
}

double distance(const Array3& a, const Array3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

using Arrangement = std::tuple<const char*, const char*, bool>;  // problem, scheme, steps of the particles' own

class OddArrangements : public testing::TestWithParam<Arrangement> {};

// gadget2 conserves. Its forces are opposite for pairs that step together; else its momentum, as its energy, drifts by
// the error of the time integration, which is largest where gas on a plane or line expands. Momentum is measured by
// sqrt(2 M E), which it would be were all energy kinetic and of one direction. sphs has only to go on.
TEST_P(OddArrangements, GoOnWithSoundNumbers) {
  const auto& [problem, scheme, individual] = GetParam();
  constexpr double end = 0.1;
  const Scene& odd = find_scene("odd");
  const ParticleSet gas = odd.build(settings_of(odd, {{"scene.problem", problem}}));
  const auto run = make_simulation(gas, settings_for(scheme, individual));
  const Totals start = run->totals();
  while (run->time() < end) {
    run->step(end);
    const Totals now = run->totals();
    ASSERT_TRUE(now.min_density > 0 && now.min_pressure > 0 && now.min_entropy > 0) << "t = " << run->time();
  }
  const Snapshot last = run->snapshot();
  for (const Field& field : last.fields)
    for (const double value : field.values) ASSERT_TRUE(std::isfinite(value)) << field.name;
  for (const double u : last.field("InternalEnergies").values) ASSERT_GT(u, 0);
  if (scheme != std::string("gadget2")) return;
  const Totals now = run->totals();
  EXPECT_NEAR(now.energy(), start.energy(), 1e-2 * start.energy());
  EXPECT_LT(distance(now.momentum, start.momentum),
            (individual ? 1e-3 : 1e-6) * std::sqrt(2 * start.mass * start.energy()));
}

INSTANTIATE_TEST_SUITE_P(OfTheScene, OddArrangements,
                         testing::Combine(testing::Values("pair", "ten", "plane", "one", "two", "ejected", "line"),
                                          testing::Values("gadget2", "sphs"), testing::Bool()));

}  // namespace
}  // namespace sphk
