// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/engine/errors.hpp"
#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

using Keys = std::vector<std::pair<std::string, std::string>>;

double measure(const Settings& settings, const Snapshot& snapshot, const std::string& name) {
  for (const auto& [key, value] : square_scene.measures(settings, snapshot))
    if (key == name) return value;
  return NAN;
}

/// The particles at `time`, at the densities, velocities and pressure of the start, with the same h everywhere.
Snapshot still(const ParticleSet& gas, double time, double h) {
  Snapshot snapshot = snapshot_of(gas, time, [](const Array3&) { return GasState{1, {}, 2.5}; });
  for (std::size_t i = 0; i < gas.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) snapshot.fields[1].values[3 * i + axis] = gas.v[i][axis];
  snapshot.fields.push_back({.name = "SmoothingLength", .values = std::vector<double>(gas.size(), h)});
  return snapshot;
}

TEST(Square, HasItsRatioWithEqualMassesOrEvenSpacing) {
  for (const char* masses : {"equal", "multi"})
    for (const int D : {2, 3}) {
      const Settings settings = settings_of(square_scene, {{"scene.n", "16"},
                                                           {"scene.ratio", "64"},
                                                           {"scene.dimension", std::to_string(D)},
                                                           {"scene.masses", masses},
                                                           {"scene.boost", "3"}});
      const auto gas = square_scene.build(settings);
      const double inner = std::pow(0.5, D);
      EXPECT_NEAR(total_mass(gas), 1 - inner + 64 * inner, 1e-12);
      const auto [least, most] = std::ranges::minmax(gas.m);
      EXPECT_NEAR(most / least, std::string(masses) == "equal" ? 1 : 64, 1e-9);
      for (std::size_t i = 0; i < gas.size(); ++i) EXPECT_EQ(gas.v[i][1], 3);
      const auto exact = square_scene.exact(settings);
      EXPECT_EQ(exact({0.5, 0.5, D == 3 ? 0.5 : 0}, 0).rho, 64);
      EXPECT_EQ(exact({0.5, 0.5, D == 3 ? 0.5 : 0}, 1.0 / 6).rho, 1);  // moved by half the box
      EXPECT_EQ(exact({0.1, 0.1, D == 3 ? 0.5 : 0}, 1.0 / 6).rho, 64);
    }
}

TEST(Square, MeasuresBlipsAndSpeeds) {
  const Settings settings = settings_of(square_scene, {{"scene.n", "8"}, {"scene.boost", "2"}});
  const auto gas = square_scene.build(settings);
  Snapshot snapshot = still(gas, 0, 0.3);
  std::vector<double>&v = snapshot.fields[1].values, &P = snapshot.fields[3].values;
  v[0] += 0.3, v[2] += 0.4;
  P[5] = 2;
  EXPECT_NEAR(measure(settings, snapshot, "pressure_error"), 0.2, 1e-14);
  EXPECT_NEAR(measure(settings, snapshot, "mach"), 0.5 / std::sqrt(5.0 / 3 * 2.5 / 4), 1e-14);
}

// Masses jump by k^D at equal density: the dense gas has k^D particles in the place of one.
TEST(Square, FinerLatticesMakeMassesJump) {
  for (const int D : {2, 3})
    for (const int k : {2, 3, 4}) {
      const auto gas = square_scene.build(settings_of(square_scene, {{"scene.n", "8"},
                                                                     {"scene.ratio", "1"},
                                                                     {"scene.finer", std::to_string(k)},
                                                                     {"scene.dimension", std::to_string(D)}}));
      const auto [least, most] = std::ranges::minmax(gas.m);
      EXPECT_NEAR(most / least, std::pow(k, D), 1e-12 * std::pow(k, D));
      EXPECT_NEAR(total_mass(gas), 1, 1e-12);
      EXPECT_EQ(gas.size(), std::pow(8, D) + (std::pow(k, D) - 1) * std::pow(4, D));
    }
}

TEST(Square, LayersSlide) {
  for (const char* D : {"2", "3"}) {
    const Settings settings = settings_of(square_scene, {{"scene.n", "8"},
                                                         {"scene.ratio", "1e6"},
                                                         {"scene.shape", "layer"},
                                                         {"scene.shear", "4"},
                                                         {"scene.boost", "1"},
                                                         {"scene.dimension", D}});
    const auto gas = square_scene.build(settings);
    EXPECT_NEAR(total_mass(gas), 0.5 + 0.5e6, 1e-7);
    EXPECT_EQ(gas.size(), std::pow(8, settings.integer("scene.dimension")));
    for (std::size_t i = 0; i < gas.size(); ++i) {
      const bool dense = std::abs(gas.x[i][1] - 0.5) < 0.25;
      EXPECT_EQ(gas.v[i], (Array3{dense ? 3.0 : -1.0, 1, 0}));
      EXPECT_EQ(gas.tag[i], dense);
    }
    const auto exact = square_scene.exact(settings);
    EXPECT_EQ(exact({0.9, 0.8, 0.9}, 0).rho, 1);
    EXPECT_EQ(exact({0.9, 0.8, 0.9}, 0).v[0], -1);
    EXPECT_EQ(exact({0.9, 0.8, 0.9}, 0.25).rho, 1e6);  // the layer has moved to 0.5 < y < 1
    EXPECT_EQ(exact({0.9, 0.8, 0.9}, 0.25).v[0], 3);
    EXPECT_EQ(exact({0.9, 0.4, 0.9}, 0.25).v[0], -1);
  }
}

TEST(Square, RefusesKeysThatContradictEachOther) {
  for (const Keys& keys :
       {Keys{{"scene.shear", "1"}}, Keys{{"scene.n", "10"}}, Keys{{"scene.finer", "2"}, {"scene.masses", "equal"}}})
    EXPECT_THROW(square_scene.build(settings_of(square_scene, keys)), InputError) << keys[0].first;
}

// A boost of 1.7 carries the gas through the box and back to 0.7 of it in t = 1; all dense gas 0.03 too far along y.
TEST(Square, MeasuresTheDriftOfTheDenseGas) {
  for (const char* shape : {"square", "layer"}) {
    const Settings settings =
        settings_of(square_scene, {{"scene.n", "8"}, {"scene.boost", "1.7"}, {"scene.shape", shape}});
    auto gas = square_scene.build(settings);
    for (std::size_t i = 0; i < gas.size(); ++i)
      for (int axis = 0; axis < 2; ++axis)
        gas.x[i][axis] = std::fmod(gas.x[i][axis] + 1.7 + (axis == 1 && gas.tag[i] ? 0.03 : 0), 1);
    EXPECT_NEAR(measure(settings, still(gas, 1, 0.3), "drift"), 0.03, 1e-12);
  }
}

// On the whole lattice of spacing s = 1/32 the widest hole is sqrt(D) s. With a ball of radius 0.1 cut out around the
// middle of a face, the next particles lie within the diagonal of a cell of its surface.
TEST(Square, FindsTheHoleCutAtItsEdge) {
  for (const int D : {2, 3}) {
    const Settings settings =
        settings_of(square_scene, {{"scene.n", "32"}, {"scene.boost", "1"}, {"scene.dimension", std::to_string(D)}});
    auto gas = square_scene.build(settings);
    const double diagonal = std::sqrt(D) / 32, h = 0.1;
    const double whole = h * measure(settings, still(gas, 0, h), "gap");
    EXPECT_NEAR(whole, diagonal, 0.005 * h);
    ParticleSet cut = gas;
    cut.x.clear(), cut.tag.clear(), cut.m.clear();
    for (std::size_t i = 0; i < gas.size(); ++i) {
      Array3 x = gas.x[i];
      if (std::hypot(x[0] - 0.25, x[1] - 0.5, D == 3 ? x[2] - 0.5 : 0) < 0.1) continue;
      x[0] = std::fmod(x[0] + 0.9, 1), x[1] = std::fmod(x[1] + 0.9, 1);
      cut.x.push_back(x), cut.tag.push_back(gas.tag[i]), cut.m.push_back(gas.m[i]);
    }
    const double hole = h * measure(settings, still(cut, 0.9, h), "gap");
    EXPECT_GE(hole, 2 * 0.1 - 0.005 * h);
    EXPECT_LE(hole, 2 * (0.1 + diagonal));
  }
}

}  // namespace
}  // namespace sphk
