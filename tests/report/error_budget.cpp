// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/error_budget.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/report/final_table.hpp"

namespace sphk {
namespace {

/// Twenty particles in 2D with m / rho = 4: mean spacings of 2. |E0| of the k-th is k; the last two meet another fluid.
struct Gas {
  Snapshot snapshot{.dimension = 2};
  std::vector<Field> errors{{.name = "E0", .components = 3}, {.name = "R", .components = 6},
                            {.name = "V", .components = 6},  {.name = "EntropyContrast"},
                            {.name = "NearestNeighbour"},    {.name = "Epsilon"}};
  Gas() {
    Field m{.name = "Masses"}, rho{.name = "Densities"}, div_v{.name = "VelocityDivergence"};
    for (int k = 1; k <= 20; ++k) {
      snapshot.id.push_back(std::uint64_t(k));
      m.values.push_back(8), rho.values.push_back(2);
      for (const double e : {0.6 * k, -0.8 * k, 0.0}) errors[0].values.push_back(e);
      for (const double r : {1.3, 1.0, 0.0, 0.4, 0.0, 0.0}) errors[1].values.push_back(r);
      for (const double v : {1.0, 1.0, 0.0, 0.0, 0.0, 0.0}) errors[2].values.push_back(v);
      errors[3].values.push_back(k > 18 ? std::log(1.3) : std::log(1.2));
      errors[4].values.push_back(k == 1 ? 0 : k == 2 ? 0.5 : 2);  // the first has no neighbour
      errors[5].values.push_back(k % 2 ? -0.3 : 0.3);
      div_v.values.push_back(k % 4 ? 5 : -5);
    }
    snapshot.fields = {m, rho, div_v};
  }
};

TEST(ErrorBudget, TellsBoundariesFromTheRest) {
  const Gas gas;
  const ErrorBudget b = error_budget(gas.snapshot, gas.errors);
  EXPECT_EQ(b.boundary.particles, 2u);
  EXPECT_EQ(b.bulk.particles, 18u);
  EXPECT_NEAR(b.all.mean, 10.5, 1e-12);
  EXPECT_NEAR(b.boundary.mean, 19.5, 1e-12);
  EXPECT_NEAR(b.bulk.mean, 9.5, 1e-12);
  EXPECT_NEAR(b.all.max, 20, 1e-12);
  EXPECT_NEAR(b.all.high, 19, 1e-12);  // 19 of 20 do not exceed it
}

// |R - 1|^2 = 0.3^2 + 2 0.4^2 = 0.41 of every particle; the third axis, which is not there, does not count.
TEST(ErrorBudget, MeasuresMatricesAndSpacings) {
  const Gas gas;
  const ErrorBudget b = error_budget(gas.snapshot, gas.errors);
  EXPECT_NEAR(b.R, std::sqrt(0.41), 1e-12);
  EXPECT_NEAR(b.V, 0, 1e-12);
  EXPECT_NEAR(b.epsilon, 0.3 / 10, 1e-12);          // of rho |div v| = 10
  EXPECT_NEAR(b.nearest, (0.25 + 18) / 19, 1e-12);  // of the 19 that have a neighbour
}

TEST(ErrorBudget, IsShownWhereItIsAskedFor) {
  RunRecord r;
  EXPECT_EQ(final_table(r).find("E0"), std::string::npos);
  const Gas gas;
  r.budget = error_budget(gas.snapshot, gas.errors);
  EXPECT_NE(final_table(r).find("where fluids meet                      2       19.5"), std::string::npos)
      << final_table(r);
}

TEST(ErrorBudget, SetsWithoutParticlesAreNan) {
  Gas gas;
  gas.errors[3].values.assign(20, 0.0);
  for (const auto& [name, value] : columns(error_budget(gas.snapshot, gas.errors)))
    EXPECT_EQ(std::isnan(value), name == "E0_boundary") << name;
}

}  // namespace
}  // namespace sphk
