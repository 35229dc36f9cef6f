// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/mixing.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "src/scenes/block.hpp"
#include "tests/scenes/engine_keys.hpp"

namespace sphk {
namespace {

constexpr int n = 64;
constexpr double k = 4 * std::numbers::pi;  // two waves in the unit box
const LayerGeometry layers{.interfaces = {0.25, 0.75}, .wavelength = 0.5};

/// A unit square of gas with rho = u = 1, dense between the interfaces by its tags, and v_y(x, y).
template <class F>
ParticleSet square(F&& v_y) {
  ParticleSet gas;
  gas.dimension = 2;
  gas.box.periodic = {true, true, false};
  gas.x = lattice_points({.dimension = 2, .counts = {n, n, 1}});
  gas.m.assign(gas.size(), 1.0 / (n * n));
  gas.u.assign(gas.size(), 1);
  for (const Array3& x : gas.x) {
    gas.v.push_back({0.3, v_y(x[0], x[1]), 0});
    gas.tag.push_back(x[1] > 0.25 && x[1] < 0.75 ? dense_gas : light_gas);
  }
  return gas;
}

ParticleSet square() {
  return square([](double, double) { return 0.0; });
}

Snapshot snapshot_of(const ParticleSet& gas) {
  return start_snapshot(gas, 5.0 / 3, [](const Array3&) { return 1.0; });
}

template <class F>
double amplitude(F&& v_y, std::array<double, 2> interfaces = {0.25, 0.75}) {
  return mode_amplitude(snapshot_of(square(v_y)), {.interfaces = interfaces, .wavelength = 0.5});
}

// S = a/2 sum w V and C = 0, or both with a shifted wave: M = a. A mean v_y and other waves drop out of whole periods.
TEST(ModeAmplitude, IsThatOfAWaveEverywhere) {
  EXPECT_NEAR(amplitude([](double x, double) { return 0.02 * std::sin(k * x); }), 0.02, 1e-15);
  EXPECT_NEAR(amplitude([](double x, double) { return 0.02 * std::sin(k * x + 1.1); }), 0.02, 1e-15);
  EXPECT_NEAR(amplitude([](double x, double) { return 0.5 + std::cos(2 * k * x); }), 0, 1e-15);
}

// Rows at distances d (j + 1/2) from the interface, d = 1/n, j = 0 .. n/4 - 1 on either side:
// sum exp(-k d (j + 1/2)) = (1 - exp(-k/4)) / (2 sinh(k d / 2)), and the same with 2k in S:
// M = a (1 + exp(-k/4)) / (2 cosh(k d / 2)).
TEST(ModeAmplitude, IsThatOfTheModeOfOneInterface) {
  const auto mode = [](double x, double y) { return 0.02 * std::sin(k * x) * std::exp(-k * std::abs(y - 0.5)); };
  EXPECT_NEAR(amplitude(mode, {0.5, 0.5}), 0.01 * (1 + std::exp(-k / 4)) / std::cosh(k / (2.0 * n)), 1e-15);
}

// The whole amplitude at one interface, none at the other.
TEST(ModeAmplitude, IsTheMeanOverTheInterfaces) {
  EXPECT_NEAR(amplitude([](double x, double y) { return y < 0.5 ? 0.02 * std::sin(k * x) : 0; }), 0.01, 1e-15);
}

// Y = 3/4 and 1/4 in a sixteenth of the rows each: 4 Y (1 - Y) = 3/4 there, half of 3/4 * 1/8 for one interface.
TEST(MixedWidth, CountsRowsThatShareTheirGas) {
  ParticleSet gas = square();
  EXPECT_EQ(mixed_width(snapshot_of(gas)), 0);
  for (std::size_t i = 0; i < gas.size(); ++i) {
    const double y = gas.x[i][1];
    if (y > 0.25 && y < 0.3125 && gas.x[i][0] < 0.25) gas.tag[i] = light_gas;
    if (y > 0.8125 && y < 0.875 && gas.x[i][0] < 0.25) gas.tag[i] = dense_gas;
  }
  EXPECT_NEAR(mixed_width(snapshot_of(gas)), 0.75 / 8 / 2, 1e-14);
}

/// Gas of density 1 on a lattice of columns x rows that is shifted along y, its origin dense below y = 1/4 + s along a
/// tooth of a saw and above 3/4 - s, -0.1 < s < 0.1: Y falls and rises linearly with y over a width of 0.2.
Snapshot saw(int columns, int rows, double shift) {
  ParticleSet gas;
  gas.dimension = 2;
  gas.box.periodic = {true, true, false};
  gas.x = lattice_points({.dimension = 2, .counts = {columns, rows, 1}});
  gas.m.assign(gas.size(), 1.0 / double(gas.size()));
  gas.u.assign(gas.size(), 1);
  gas.v.assign(gas.size(), {});
  for (Array3& x : gas.x) {
    x[1] = wrapped(x[1] + shift, 1);
    const double edge = 0.25 + 0.2 * (x[0] - 0.5);
    gas.tag.push_back(x[1] < edge || x[1] > 1 - edge ? dense_gas : light_gas);
  }
  return snapshot_of(gas);
}

// The integral of f = 4 Y (1 - Y) over a zone of width w in which Y is linear is 2 w / 3, with w = 0.2. Rows of
// particles sum it at distances d = 1 / rows: off by f'' w d^2 / 24 = d^2 / (3 w) inside, and by up to f' d^2 / 8 = d^2
// / (2 w) at each of the two bends, where f' = 4 / w. A hundredth is for the saw's steps of 1 / columns.
TEST(MixedWidth, HangsNeitherOnTheNumberOfParticlesNorOnTheirPlaces) {
  for (const int side : {24, 64, 100, 300})
    for (const double shift : {0.0, 0.003, 0.0117}) {
      const double d = 1.0 / side, w = 0.2;
      EXPECT_NEAR(mixed_width(saw(side, side, shift)), 2 * w / 3, 0.01 * 2 * w / 3 + 4 * d * d / (3 * w))
          << side << " particles, " << shift;
    }
}

// Rows without a centre hold the particles beside them, and nothing is mixed where the gases meet at an edge of theirs.
TEST(MixedWidth, IsZeroOfWhatLiesApartInRowsOfAnyNumber) {
  for (const int rows : {8, 16, 36, 100, 512}) {
    ParticleSet gas;
    gas.dimension = 2;
    gas.box.periodic = {true, true, false};
    gas.x = lattice_points({.dimension = 2, .counts = {rows, rows, 1}});
    gas.m.assign(gas.size(), 1.0 / double(gas.size()));
    gas.u.assign(gas.size(), 1);
    gas.v.assign(gas.size(), {});
    for (const Array3& x : gas.x) gas.tag.push_back(x[1] > 0.25 && x[1] < 0.75 ? dense_gas : light_gas);
    EXPECT_NEAR(mixed_width(snapshot_of(gas)), 0, 1e-12) << rows;
    for (std::size_t i = 0; i < gas.size(); ++i) gas.tag[i] = i % std::size_t(rows) * 2 < std::size_t(rows);
    EXPECT_NEAR(mixed_width(snapshot_of(gas)), 0, 1e-12) << rows;
  }
}

// A = A_dense^(1-s) A_light^s for a share s. u = A / (gamma - 1) at rho = 1. s = 0.5 for a quarter of the mass.
TEST(MixedEntropy, CountsWhatLiesBetween) {
  ParticleSet gas = square();
  const LayerGeometry contrast{.A_light = 8, .A_dense = 2};
  const double shares[] = {0, 0.5, 0.95, 0.05};
  for (std::size_t i = 0; i < gas.size(); ++i) gas.u[i] = 1.5 * 2 * std::pow(4, shares[i % 4]);
  EXPECT_NEAR(mixed_entropy_fraction(snapshot_of(gas), contrast), 0.25, 1e-12);
}

// A quarter of the dense layer's rows moves out, by half a box; light gas moving in does not count.
TEST(Crossed, IsTheShareOfDenseGasThatLeft) {
  ParticleSet gas = square();
  EXPECT_EQ(crossed_fraction(snapshot_of(gas), layers), 0);
  for (Array3& x : gas.x)
    if (std::abs(x[1] - 0.25) < 0.125) x[1] = std::fmod(x[1] + 0.5, 1.0);
  EXPECT_NEAR(crossed_fraction(snapshot_of(gas), layers), 0.25, 1e-12);
}

// 4 particles of mass 1, 2, 3, 4; those of mass 2 and 4 are dense in origin and cold; 2 alone is dense still:
// cloud_mass = 2/6, cloud_velocity = (2 * 0.5 + 4 * 2) / 6 = 1.5. Below u = 0.15 lies what was 0.1, and of the cloud
// all but the mass of 2 once that has 0.2; light gas as cold does not count.
TEST(Cloud, HasMassAndVelocity) {
  ParticleSet gas;
  gas.x.assign(4, {0.5, 0.5, 0.5});
  gas.m = {1, 2, 3, 4};
  gas.u = {1, 0.1, 1, 0.1};
  gas.v = {{9, 0, 0}, {0.5, 0, 0}, {9, 0, 0}, {2, 0, 0}};
  gas.tag = {light_gas, dense_gas, light_gas, dense_gas};
  Snapshot snapshot = snapshot_of(gas);
  for (Field& field : snapshot.fields)
    if (field.name == "Densities") field.values = {1, 10, 10, 5};
  EXPECT_NEAR(cloud_mass(snapshot, {.least_density = 6.4, .highest_energy = 0.9}), 1.0 / 3, 1e-15);
  EXPECT_NEAR(cloud_velocity(snapshot), 1.5, 1e-15);
  EXPECT_EQ(cold_share(snapshot, 0.15), 1);
  for (Field& field : snapshot.fields)
    if (field.name == "InternalEnergies") field.values = {0.1, 0.2, 0.1, 0.1};
  EXPECT_NEAR(cold_share(snapshot, 0.15), 4.0 / 6, 1e-15);
}

}  // namespace
}  // namespace sphk
