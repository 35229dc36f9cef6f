// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/trial_gas.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

#include "src/run/problem.hpp"

namespace sphk {
namespace {

Problem uniform(const std::string& n, const std::string& dimension) {
  return resolve_problem("uniform", overrides_of({{"scene.n", n},
                                                  {"scene.dimension", dimension},
                                                  {"scene.lattice", "cubic"},
                                                  {"sph.kernel", "cs"},
                                                  {"sph.neighbours", dimension == "3" ? "48" : "20"}}));
}

TEST(TrialGas, IsAllOfItWhereParticlesAreFew) {
  const Problem problem = uniform("20", "3");
  const TrialGas trial = trial_gas(*problem.scene, problem.settings);
  EXPECT_EQ(trial.particles, 8000);
  EXPECT_EQ(trial.gas.size(), 8000u);
  EXPECT_EQ(trial.refinement, 1);
}

// 1600^3 is halved five times: 50^3 fit in.
TEST(TrialGas, TellsHowManyALargeSceneHas) {
  const Problem cube = uniform("1600", "3"), square = uniform("3000", "2");
  const TrialGas trial = trial_gas(*cube.scene, cube.settings);
  EXPECT_NEAR(trial.particles, 4.096e9, 1);
  EXPECT_EQ(trial.gas.size(), 125000u);
  EXPECT_EQ(trial.refinement, 32);
  EXPECT_NEAR(trial_gas(*square.scene, square.settings).particles, 9e6, 1);
  const Problem odd = uniform("1001", "3");
  EXPECT_NEAR(trial_gas(*odd.scene, odd.settings).particles, 1001.0 * 1001 * 1001, 1);
}

/// Of a gas without a resolution, such as a file's, every third particle, three times as heavy.
TEST(TrialGas, ThinsWhatHasNoResolution) {
  struct Line : Scene {
    std::string name() const override { return "line"; }
    std::string summary() const override { return "600000 particles on a line"; }
    void declare(Settings&) const override {}
    int dimension(const Settings&) const override { return 1; }
    ParticleSet build(const Settings&) const override {
      ParticleSet gas{.dimension = 1};
      for (int i = 0; i < 600000; ++i) gas.x.push_back({i / 6e5, 0, 0}), gas.m.push_back(1 / 6e5);
      gas.v.assign(gas.x.size(), {});
      gas.u.assign(gas.x.size(), 1);
      return gas;
    }
  };
  const TrialGas trial = trial_gas(Line(), Settings());
  EXPECT_EQ(trial.particles, 600000);
  EXPECT_EQ(trial.gas.size(), 200000u);
  EXPECT_EQ(trial.refinement, 3);
  EXPECT_NEAR(std::accumulate(trial.gas.m.begin(), trial.gas.m.end(), 0.0), 1, 1e-9);
  for (std::size_t k = 0; k < trial.gas.size(); ++k) ASSERT_EQ(int(trial.gas.x[k][0] * 6e5 + 0.5) / 3, int(k));
}

/// 1e15 particles are more than any machine has memory for; a small box is always let through.
TEST(Memory, IsRefusedBeforeItIsTaken) {
  const Problem endless = uniform("100000", "3"), small = uniform("20", "3");
  EXPECT_THROW(require_memory(*endless.scene, endless.settings), std::runtime_error);
  EXPECT_NO_THROW(require_memory(*small.scene, small.settings));
  EXPECT_THROW(require_memory(1e15, 500), std::runtime_error);
}

}  // namespace
}  // namespace sphk
