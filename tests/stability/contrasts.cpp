// SPDX-License-Identifier: BSD-3-Clause
#include "src/stability/contrasts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace sphk {
namespace {

/// Particles of a lattice, n along the unit box, that is periodic; mass 1 and u = 1 each.
ParticleSet lattice(int dimension, int n) {
  ParticleSet gas;
  gas.dimension = dimension;
  const auto count = [&](int axis) { return axis < dimension ? n : 1; };
  const auto at = [&](int i, int axis) { return axis < dimension ? (i + 0.5) / n : 0; };
  for (int i = 0; i < count(0); ++i)
    for (int j = 0; j < count(1); ++j)
      for (int k = 0; k < count(2); ++k) gas.x.push_back({at(i, 0), at(j, 1), at(k, 2)});
  for (int axis = 0; axis < dimension; ++axis) gas.box.periodic[std::size_t(axis)] = true;
  gas.v.assign(gas.size(), {});
  gas.m.assign(gas.size(), 1);
  gas.u.assign(gas.size(), 1);
  return gas;
}

/// Dense gas in 0.3 < x < 0.7, by heavier particles, with u so that the pressure is `hotter` times that of the rest.
ParticleSet layer(int dimension, double denser, double hotter) {
  ParticleSet gas = lattice(dimension, dimension == 3 ? 16 : 40);
  for (std::size_t i = 0; i < gas.size(); ++i)
    if (gas.x[i][0] > 0.3 && gas.x[i][0] < 0.7) gas.m[i] = denser, gas.u[i] = hotter / denser;
  return gas;
}

TEST(Contrasts, AreOneInEvenGas) {
  for (const int dimension : {1, 2, 3}) {
    const Contrasts even = contrasts(lattice(dimension, 16));
    EXPECT_NEAR(even.density, 1, 1e-12) << dimension;
    EXPECT_NEAR(even.pressure, 1, 1e-12) << dimension;
    EXPECT_EQ(even.mass, 1);
    EXPECT_EQ(even.without_heat, 0u);
  }
}

// Of 16 particles in a box the number in a box of that size scatters by a quarter: sixteen times, three boxes in line,
// stay within a factor of about 10, far from 80.
TEST(Contrasts, AreSmallInRandomGas) {
  for (const int dimension : {1, 2, 3}) {
    ParticleSet gas = lattice(dimension, dimension == 3 ? 20 : dimension == 2 ? 90 : 8000);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> anywhere(0, 1);
    for (Array3& x : gas.x)
      for (int axis = 0; axis < dimension; ++axis) x[std::size_t(axis)] = anywhere(random);
    EXPECT_LT(contrasts(gas).density, 30) << dimension;
    EXPECT_LT(contrasts(gas).pressure, 30) << dimension;
  }
}

// A box that the edge cuts shows a mixture, the boxes at its sides the whole: 100 as 80 at least, 3 as 3.
TEST(Contrasts, AreThoseOfTheGasesThatMeet) {
  for (const int dimension : {1, 2, 3})
    for (const double factor : {3.0, 100.0, 1e6}) {
      const Contrasts balanced = contrasts(layer(dimension, factor, 1)), hot = contrasts(layer(dimension, 1, factor));
      EXPECT_GT(balanced.density, 0.8 * factor) << dimension;
      EXPECT_LT(balanced.density, 1.25 * factor) << dimension;
      EXPECT_NEAR(balanced.pressure, 1, 1e-9) << dimension;
      EXPECT_EQ(balanced.mass, factor);
      EXPECT_GT(hot.pressure, 0.8 * factor) << dimension;
      EXPECT_LT(hot.pressure, 1.25 * factor) << dimension;
      EXPECT_EQ(hot.mass, 1);
    }
}

// Dense gas of equal masses, eleven times finer, is as dense as 11^2; dense gas of as much more pressure is no contact.
TEST(Contrasts, SeeDensitiesOfEqualMassesAndPassShocksBy) {
  ParticleSet gas = lattice(2, 16), fine = lattice(2, 11 * 16);
  std::erase_if(gas.x, [](const Array3& x) { return x[0] < 0.5; });
  std::erase_if(fine.x, [](const Array3& x) { return x[0] > 0.5; });
  const std::size_t thin = gas.x.size();
  gas.x.insert(gas.x.end(), fine.x.begin(), fine.x.end());
  gas.v.assign(gas.size(), {}), gas.m.assign(gas.size(), 1), gas.u.assign(gas.size(), 1.0 / 121);
  std::fill_n(gas.u.begin(), thin, 1.0);
  EXPECT_NEAR(contrasts(gas).density, 121, 0.2 * 121);
  gas.u.assign(gas.size(), 1);
  EXPECT_LT(contrasts(gas).density, 3.1) << "as much denser as its pressure is higher";
  EXPECT_NEAR(contrasts(gas).pressure, 121, 0.2 * 121);
}

// All at one place, on a line, far apart, alone: no box has room.
TEST(Contrasts, SurviveOddArrangements) {
  ParticleSet gas = lattice(3, 6);
  for (const int kept : {0, 1, 2, 3}) {
    ParticleSet flat = gas;
    for (Array3& x : flat.x)
      for (int axis = kept; axis < 3; ++axis) x[std::size_t(axis)] = 0.25;
    for (const bool periodic : {true, false}) {
      flat.box.periodic.fill(periodic);
      EXPECT_NEAR(contrasts(flat).mass, 1, 1e-12);
      EXPECT_GE(contrasts(flat).density, 1) << kept;
    }
  }
  gas.x.resize(1), gas.m.resize(1), gas.u = {0};
  EXPECT_EQ(contrasts(gas).density, 1);
  EXPECT_EQ(contrasts(gas).without_heat, 1u);
}

}  // namespace
}  // namespace sphk
