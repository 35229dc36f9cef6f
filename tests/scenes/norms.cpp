// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/norms.hpp"

#include <gtest/gtest.h>

#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

GasState at_rest(const Array3&, double) {
  return {1, {}, 1};
}

// Bin 1 of [0, 0.02): particles with v 1 and 3, mean 2; bin 2: v = -1 alone. Mean |error| = (2 + 1)/2, over particles
// (1 + 3 + 1)/3. The particle at 0.5 lies outside.
TEST(Norms, BinsMeansBeforeTheyAreCompared) {
  ParticleSet gas;
  gas.x = {{0.001, 7, 0}, {0.009, 0, 0}, {0.015, 0, 0}, {0.5, 0, 0}};
  const auto snapshot = snapshot_of(gas, 0, [](const Array3& x) {
    return GasState{1, {x[0] < 0.005 ? 1.0 : x[0] < 0.01 ? 3.0 : x[0] < 0.1 ? -1.0 : 99.0, 50, 0}, 1};
  });
  const auto errors = profile_errors(snapshot, along_x(0, 0.02), at_rest);
  EXPECT_NEAR(errors.at("v").l1, 1.5, 1e-15);
  EXPECT_NEAR(errors.at("v").l2, std::sqrt(2.5), 1e-15);
  EXPECT_NEAR(errors.at("v").linf, 2, 1e-15);
  EXPECT_NEAR(errors.at("v").where[0], 0.005, 1e-15);
  EXPECT_NEAR(errors.at("v_particles").l1, 5.0 / 3, 1e-15);
  EXPECT_NEAR(errors.at("v_particles").where[0], 0.009, 1e-15);
  EXPECT_EQ(errors.at("rho").l1, 0);
}

// v = 100 x. Of particles at 0.002 and 0.004 the mean is 0.3, while v is 0.5 at the centre of the bin [0, 0.01).
TEST(Norms, MeansAreComparedWithTheMeanOverTheSamePlaces) {
  const auto line = [](const Array3& x, double) { return GasState{1, {100 * x[0], 0, 0}, 1}; };
  const auto found = [&](double first, double second, double excess) {
    ParticleSet gas;
    gas.x = {{first, 0, 0}, {second, 0, 0}};
    const auto state = [&](const Array3& x) { return GasState{1, {100 * x[0] + excess, 0, 0}, 1}; };
    return profile_errors(snapshot_of(gas, 0, state), along_x(0, 0.01), line);
  };
  EXPECT_EQ(found(0.002, 0.004, 0).at("v").linf, 0);
  EXPECT_NEAR(found(0.002, 0.004, 0).at("v_centres").l1, 0.2, 1e-15);
  EXPECT_NEAR(found(0.002, 0.004, 0.5).at("v").l1, 0.5, 1e-15);
  EXPECT_NEAR(found(0.002, 0.004, 0.5).at("v_centres").l1, 0.3, 1e-15);
}

TEST(Norms, HaveAMeaningEach) {
  ParticleSet gas;
  gas.x = {{0.5, 0, 0}};
  for (const auto& [name, norm] :
       profile_errors(snapshot_of(gas, 0, [](const Array3&) { return GasState{}; }), along_x(0, 1), at_rest))
    EXPECT_FALSE(meaning_of_error(name).empty()) << name;
  for (const char* name : {"M", "", "v_middles", "_particles"}) EXPECT_EQ(meaning_of_error(name), "") << name;
}

// Empty bins are left out: the mean is over the one that has a particle.
TEST(Norms, LeavesOutEmptyBins) {
  ParticleSet gas;
  gas.x = {{0.555, 0, 0}};
  const auto snapshot = snapshot_of(gas, 0, [](const Array3&) { return GasState{3, {}, 1}; });
  EXPECT_NEAR(profile_errors(snapshot, along_x(0, 1), at_rest).at("rho").l1, 2, 1e-15);
}

TEST(Norms, SaysNothingWhereThereIsNoParticle) {
  ParticleSet gas;
  gas.x = {{2, 0, 0}};
  const auto snapshot = snapshot_of(gas, 0, [](const Array3&) { return GasState{}; });
  EXPECT_TRUE(profile_errors(snapshot, along_x(0, 1), at_rest).empty());
  EXPECT_TRUE(profile_errors(snapshot, along_r(-0.5), at_rest).empty());
}

// v = (1, 2, 3) at (0, 2, 0): radial 2, azimuthal -1 (the azimuthal unit vector is (-1, 0, 0) there).
TEST(Norms, ProjectsTheVelocity) {
  const Array3 x{0, 2, 0}, v{1, 2, 3};
  const auto project = [&](const ProfileLine& line) {
    const Array3 e = line.direction(x);
    return e[0] * v[0] + e[1] * v[1] + e[2] * v[2];
  };
  EXPECT_EQ(project(along_x(0, 1)), 1);
  EXPECT_EQ(project(along_r(1)), 2);
  EXPECT_EQ(project(along_R(1)), -1);
  EXPECT_EQ(along_r(1).coordinate({2, 3, 6}), 7);
  EXPECT_EQ(along_R(1).coordinate({3, 4, 6}), 5);
}

TEST(Norms, NanIsNotHidden) {
  ParticleSet gas;
  gas.x = {{0.5, 0, 0}};
  const auto snapshot = snapshot_of(gas, 0, [](const Array3&) { return GasState{std::nan(""), {}, 1}; });
  const auto norm = profile_errors(snapshot, along_x(0, 1), at_rest).at("rho_particles");
  EXPECT_TRUE(std::isnan(norm.l1) && std::isnan(norm.linf));
}

}  // namespace
}  // namespace sphk
