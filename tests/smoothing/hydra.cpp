// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/smoothing/hydra.hpp"

#include <gtest/gtest.h>

namespace sphk {
namespace {

// The cubic spline is steepest where -12q + 18q^2 has its minimum, at q = 1/3: -2.
TEST(Hydra, TheSlopeIsFrozenAtItsSteepest) {
  for (const double q : {0.0, 0.1, 0.33}) EXPECT_NEAR(Hydra{}(q).dw, -2, 1e-15);
  EXPECT_NEAR(Hydra{}(0.4).dw, -12 * 0.4 + 18 * 0.16, 1e-15);
}

TEST(Hydra, ItsOwnDerivativeIsTheSplines) {
  EXPECT_EQ(with_own_derivative(Hydra{}, 0.0).dw, 0);
  EXPECT_NEAR(with_own_derivative(Hydra{}, 0.1).dw, -12 * 0.1 + 18 * 0.01, 1e-15);
}

}  // namespace
}  // namespace sphk
