// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/smoothing/norm.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/smoothing/list.hpp"

namespace sphk {
namespace {

constexpr double pi = 3.14159265358979323846;

// Integral of (b-q)^2 q from a to b is (b-a)^3 (b+3a)/12; of (1-q)^3 q^2 from 0 to 1 it is B(3, 4) = 1/60.
TEST(Norm, MomentsOfTruncatedPowers) {
  EXPECT_NEAR(power_moment(2, 2, 0.75, 0.2), std::pow(0.55, 3) * (0.75 + 0.6) / 12, 1e-16);
  EXPECT_NEAR(power_moment(3, 3, 1), 1.0 / 60, 1e-16);
  EXPECT_NEAR(core_moment(3, 2, -1, 0.3), 2 * 0.027 / 3 - 0.0081 / 4, 1e-16);
}

/// Norms in 1D, 2D and 3D.
struct Norms {
  const char* kernel;
  double one, two, three;
};

// R10 and V10 print six decimals or fewer; the others are closed forms (Dehnen & Aly 2012, table 1, scaled to the
// support radius; Johnson in V10 sec 3).
TEST(Norm, EqualsThePrintedOnes) {
  const Norms printed[] = {
      {"cs", 4.0 / 3, 1.818914, 2.546479},      {"ct", 1.270588, 1.793607, 2.535350},
      {"hoct3", 1.623102, 2.458206, 3.711856},  {"hoct4", 2.068435, 3.715833, 6.515050},
      {"hoct5", 2.499430, 5.214416, 10.431866}, {"hoct8", 3.775521, 11.196838, 30.753807},
      {"liq", 2.237136, 2.961941, 3.947622},    {"hydra", 4.0 / 3, 1.818914, 2.546479},
      {"johnson", 1.5, 6 / pi, 7.5 / pi},       {"m5", 4.069010, 6.222175, 9.714047},
      {"m6", 6.075, 10.194573, 17.403593},      {"wc2", 1.5, 7 / pi, 21 / (2 * pi)},
      {"wc4", 1.6875, 9 / pi, 495 / (32 * pi)}, {"wc6", 1.875, 78 / (7 * pi), 1365 / (64 * pi)},
      {"ct-cs", 4.0 / 3, 1.818914, 2.546479},
  };
  EXPECT_EQ(std::size(printed), smoothing_kernel_names().size());
  for (const Norms& norms : printed)
    with_kernel(norms.kernel, [&](const auto& kernel) {
      EXPECT_NEAR(kernel.norm(1), norms.one, 6e-7) << norms.kernel;
      EXPECT_NEAR(kernel.norm(2), norms.two, 6e-7) << norms.kernel;
      EXPECT_NEAR(kernel.norm(3), norms.three, 6e-7) << norms.kernel;
    });
}

/// A force kernel of its own has a norm of its own: -integral of r dW/dr is D times the integral of W, 1.
TEST(Norm, OfForcesApartFromTheDensity) {
  constexpr double spheres[] = {2, 2 * pi, 4 * pi};
  const CoreTriangleForces kernel;
  for (int D = 1; D <= 3; ++D) {
    double integral = 0;
    constexpr int panels = 3000;  // the joints at 1/3 and 1/2 are edges of panels
    for (int k = 0; k < panels; ++k) {
      const double q = (k + 0.5) / panels;
      integral -= spheres[D - 1] * std::pow(q, D) * kernel(q).dw / panels;
    }
    EXPECT_NEAR(norm_of_forces(kernel, D) * integral, D, 1e-6) << D;  // midpoints: w'''/(24 panels^2)
    EXPECT_EQ(kernel.norm(D), CubicSpline{}.norm(D));
    EXPECT_EQ(kernel(0.2).w, CubicSpline{}.w(0.2));
    EXPECT_EQ(kernel(0.2).dw, CoreTriangle{}(0.2).dw);
  }
}

}  // namespace
}  // namespace sphk
