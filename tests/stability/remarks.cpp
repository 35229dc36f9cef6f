// SPDX-License-Identifier: BSD-3-Clause
#include "src/stability/remarks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "src/schemes/registry.hpp"

namespace sphk {
namespace {

// S12 Table 1, "simple", to its two decimals.
TEST(Remarks, LatticeDensitiesAreThoseOfS12) {
  EXPECT_NEAR(lattice_density({"cs", 32}, 3), 1.00, 0.005);
  EXPECT_NEAR(lattice_density({"cs", 128}, 3), 1.00, 0.005);
  EXPECT_NEAR(lattice_density({"ct", 32}, 3), 1.07, 0.005);
  EXPECT_NEAR(lattice_density({"ct", 128}, 3), 1.02, 0.005);
  EXPECT_NEAR(lattice_density({"hoct4", 442}, 3), 1.01, 0.005);
}

TEST(Remarks, APairThatMeasuresDensitiesBadlyIsTold) {
  EXPECT_EQ(sampling_remark({"cs", 48}, {"cs", 48}, 3), "");
  const std::string remark = sampling_remark({"hoct4", 48}, {"hoct4", 442}, 3);
  EXPECT_NE(remark.find("hoct4 with 48 neighbours"), std::string::npos) << remark;
  EXPECT_NE(remark.find("hoct4 with 442 is 0.8 % off"), std::string::npos) << remark;
  EXPECT_NE(sampling_remark({"cs", 1.5}, {"cs", 48}, 3), "") << "one neighbour is the particle itself";
}

/// Largest speed of a line of particles with round-off's motion, after some steps of C.
double speed_after(double courant, int steps) {
  constexpr int n = 64;
  ParticleSet gas;
  gas.dimension = 1;
  gas.box.periodic[0] = true;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> small(-1e-8, 1e-8);
  for (int i = 0; i < n; ++i) {
    gas.x.push_back({(i + 0.5) / n, 0, 0});
    gas.v.push_back({small(random), 0, 0});
    gas.m.push_back(1.0 / n);
    gas.u.push_back(1);
  }
  const auto run = make_simulation(gas, {.scheme = "sph",
                                         .kernel = "wc4",
                                         .precision = "double",
                                         .neighbours = 6,
                                         .courant = courant,
                                         .numbers = {{"viscosity.alpha", 0}, {"viscosity.beta", 0}}});
  for (int step = 0; step < steps; ++step) run->step(1e9);
  return run->totals().max_speed;
}

TEST(Remarks, AboveTheLargestCourantNumberSoundGrows) {
  const double largest = largest_courant({"wc4", 6}, 1, 5.0 / 3);
  EXPECT_LT(speed_after(0.98 * largest, 300), 1e-6);
  EXPECT_GT(speed_after(1.25 * largest, 300), 1e-4);
  EXPECT_EQ(courant_remark(0.4, {"wc4", 6}, 1, 5.0 / 3), "");
  EXPECT_NE(courant_remark(1.1 * largest, {"wc4", 6}, 1, 5.0 / 3), "");
}

}  // namespace
}  // namespace sphk
