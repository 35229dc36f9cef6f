// SPDX-License-Identifier: BSD-3-Clause

// Every term on two particles in 1D against values worked out by hand, in double: equal to a few roundings.
#include <cmath>

#include "tests/terms/two_particles.hpp"

namespace sphk::test {
namespace {

constexpr double rounding = 1e-14;

TEST(Terms, PressureGradientOfSph) {
  const TwoParticles<double, 1> p;
  // -m_j (P_i/rho_i^2 + P_j/rho_j^2) dWbar/dr, e = +1: P/rho^2 = 2.4 and 14.4.
  const double wanted = -2 * (2.4 + 14.4) * 0.5 * (dW_i_1d + dW_j_1d);
  EXPECT_NEAR((share<PressureGradientSph, double, 1>(p.i, p.j).a[0]), wanted, rounding * std::abs(wanted));
}

TEST(Terms, PressureGradientOfTsph) {
  const TwoParticles<double, 1> p;
  const double wanted = -2 * (0.6 + 0.9) / (0.5 * 0.25) * 0.5 * (dW_i_1d + dW_j_1d);
  EXPECT_NEAR((share<PressureGradientTsph, double, 1>(p.i, p.j).a[0]), wanted, rounding * std::abs(wanted));
}

TEST(Terms, ConservativePressureGradient) {
  const TwoParticles<double, 1> p;
  // -[P_i/rho_i^2 (m_j + z_i) dW(h_i) + (m_j/m_i) P_j/rho_j^2 (m_i + z_j) dW(h_j)], z = 1/8 and -1/4.
  const double wanted = -(2.4 * (2 + 0.125) * dW_i_1d + 2 * 14.4 * (1 - 0.25) * dW_j_1d);
  EXPECT_NEAR((share<PressureGradientConservative, double, 1>(p.i, p.j).a[0]), wanted, rounding * std::abs(wanted));
}

TEST(Terms, PressureWork) {
  const TwoParticles<double, 1> p;
  // P_i/rho_i^2 m_j v_ij . grad Wbar, v_ij = -1: compression heats.
  const double wanted = 2.4 * 2 * -1 * 0.5 * (dW_i_1d + dW_j_1d);
  EXPECT_GT(wanted, 0);
  EXPECT_NEAR((share<PressureWork, double, 1>(p.i, p.j).du), wanted, rounding * wanted);
}

TEST(Terms, PressureWorkOfTsph) {
  const TwoParticles<double, 1> p;
  // P_i/rho_i m_j/rho_j v_ij . grad Wbar.
  const double wanted = 0.6 / 0.5 * 2 / 0.25 * -1 * 0.5 * (dW_i_1d + dW_j_1d);
  EXPECT_NEAR((share<PressureWorkTsph, double, 1>(p.i, p.j).du), wanted, rounding * wanted);
}

TEST(Terms, TensileCorrectionOfMonaghan) {
  const TwoParticles<double, 1> p;
  // W: 4/3 [2 (1/4)^3]/2 = 1/48 and 4/3 [2 (1/2)^3]/3 = 1/9; f = half their sum times the mean of 1/W(d), 4 and 6; R =
  // 0.3 (P_i + P_j)/(rho_i rho_j) = 3.6. Its work is shared: approaching at speed 1, it heats.
  const double f = 0.5 * (1.0 / 48 + 1.0 / 9) * 5, push = 2 * 3.6 * std::pow(f, 4), dW = 0.5 * (dW_i_1d + dW_j_1d);
  const auto sum = share<TensileCorrection, double, 1>(p.i, p.j, {{"tensile.epsilon", 0.3}});
  EXPECT_NEAR(sum.a[0], -push * dW, 4 * rounding * std::abs(push * dW));
  EXPECT_NEAR(sum.du, 0.5 * push * -1 * dW, 4 * rounding * std::abs(push * dW));
  EXPECT_GT(sum.a[0], 0) << "it pushes i away from j";
}

TEST(Terms, GingoldMonaghanViscosity) {
  const TwoParticles<double, 1> p;
  // hs = 5/4; mu = hs (v.r)/(r^2 + 0.01 hs^2) = 1.25 * -1.5/(2.25 + 0.015625); c = sqrt(2), sqrt(6); Balsara mean 3/4;
  // rho_ij = 3/8; Pi = (-alpha cbar mu + beta mu^2)/rho_ij * 3/4.
  const double mu = -1.875 / 2.265625, c_bar = 0.5 * (std::sqrt(2.0) + std::sqrt(6.0));
  const double Pi = (-1.5 * c_bar * mu + 3 * mu * mu) / 0.375 * 0.75, dW = 0.5 * (dW_i_1d + dW_j_1d);
  const auto sum =
      share<ViscosityGingoldMonaghan<>, double, 1>(p.i, p.j, {{"viscosity.alpha", 1.5}, {"viscosity.beta", 3}});
  EXPECT_NEAR(sum.a[0], -2 * Pi * dW, 4 * rounding * std::abs(2 * Pi * dW));
  EXPECT_NEAR(sum.du, 0.5 * 2 * Pi * -1 * dW, 4 * rounding * std::abs(Pi * dW));
  EXPECT_GT(sum.du, 0) << "viscosity heats";
}

TEST(Terms, SignalVelocityViscosity) {
  const TwoParticles<double, 1> p;
  // v_sig = c_i + c_j - 3 w, w = -1; Pi = -(alpha/2) v_sig w / rho_ij times the mean Balsara factor 3/4.
  const double v_sig = std::sqrt(2.0) + std::sqrt(6.0) + 3, Pi = 0.5 * 0.8 * v_sig / 0.375 * 0.75;
  const double dW = 0.5 * (dW_i_1d + dW_j_1d);
  const auto sum = share<ViscositySignalVelocity<>, double, 1>(p.i, p.j, {{"viscosity.alpha", 0.8}});
  EXPECT_NEAR(sum.a[0], -2 * Pi * dW, 4 * rounding * std::abs(2 * Pi * dW));
  EXPECT_NEAR(sum.du, -Pi * dW, 4 * rounding * std::abs(Pi * dW));
}

TEST(Terms, SwitchedViscosity) {
  const TwoParticles<double, 1> p;
  // v_sig = c_i + c_j - 3 w, w = -1; Pi = -(alpha_v/2) alpha_ij v_sig w / rho_ij, alpha_ij = (1/2 + 1/4)/2.
  const double v_sig = std::sqrt(2.0) + std::sqrt(6.0) + 3, Pi = 0.5 * 0.8 * 0.375 * v_sig / 0.375;
  const double dW = 0.5 * (dW_i_1d + dW_j_1d);
  const auto sum = share<ViscositySwitched<>, double, 1>(p.i, p.j, {{"viscosity.alpha", 0.8}});
  EXPECT_NEAR(sum.a[0], -2 * Pi * dW, 4 * rounding * std::abs(2 * Pi * dW));
  EXPECT_NEAR(sum.du, -Pi * dW, 4 * rounding * std::abs(Pi * dW));
}

TEST(Terms, EntropyDissipation) {
  const TwoParticles<double, 1> p;
  // (m_j/rho_ij) alpha_ij v_sig^p L_ij (u_i - u_j) dWbar: alpha_ij = (3/4 + 3/8)/2, L = 0.3/1.5, u = P/((gamma-1) rho).
  const double v_sig = std::sqrt(2.0) + std::sqrt(6.0) + 3, dW = 0.5 * (dW_i_1d + dW_j_1d);
  const double wanted = 0.7 * 2 / 0.375 * 0.5625 * v_sig * 0.2 * (1.8 - 5.4) * dW;
  const Given given{{"sph.gamma", 5.0 / 3}, {"dissipation.entropy", 0.7}};
  EXPECT_NEAR((share<EntropyDissipation<>, double, 1>(p.i, p.j, given).du), wanted, 8 * rounding * wanted);
}

TEST(Terms, LargestSignalVelocity) {
  TwoParticles<double, 1> p;
  const double wanted = std::sqrt(2.0) + std::sqrt(6.0) + 3;
  EXPECT_NEAR((share<SignalVelocity, double, 1>(p.i, p.j).v_sig), wanted, rounding * wanted);
  p.i.x[0] = 3;  // r = max(h_i, h_j): outside
  EXPECT_EQ((share<SignalVelocity, double, 1>(p.i, p.j).v_sig), 0);
  EXPECT_NEAR((share<SignalVelocity, double, 1>(p.j, p.j).v_sig), 2 * std::sqrt(6.0), 1e-14) << "the self pair: 2 c";
}

TEST(Terms, LargestSignalVelocityOfMonaghan) {
  const TwoParticles<double, 1> p;
  const Given given{{"viscosity.alpha", 1.5}, {"viscosity.beta", 3}};
  const double mu = -1.875 / 2.265625, wanted = 2 * (2.5 * std::sqrt(2.0) - 3 * mu);
  EXPECT_NEAR((share<SignalVelocityMonaghan, double, 1>(p.i, p.j, given).v_sig), wanted, rounding * wanted);
  EXPECT_NEAR((share<SignalVelocityMonaghan, double, 1>(p.i, p.i, given).v_sig), 5 * std::sqrt(2.0), rounding * wanted);
}

TEST(Terms, VelocityDivergenceAndKernelOfAGatherPair) {
  const TwoParticles<double, 1> p;
  Values<double, 1, VelocityDivergenceSum::Adds> sum;
  set_zero(sum);
  const auto ij = gather_pair<double, 1>(Smoothing<CubicSpline, 1>(CubicSpline{}), p.i, seen_from(p.i, p.j));
  VelocityDivergenceSum{}(sum, p.i, p.j, ij);
  // W = 4/3/2 * 2 (1/4)^3 = 1/48; dW/dh = -(4/3)/4 (w + q w') = -(1/3)(1/32 - 9/32) = 1/12.
  EXPECT_NEAR(ij.W, 1.0 / 48, rounding);
  EXPECT_NEAR(ij.dW_dh, 1.0 / 12, rounding);
  EXPECT_NEAR(sum.div_v, -2 * -1 * dW_i_1d, rounding) << "not yet divided by rho: converging flow, negative";
}

TEST(Terms, CurlOfAPairInTwoDimensions) {
  const TwoParticles<double, 2> p;
  VelocityCurlSum term;
  Values<double, 2, VelocityCurlSum::Adds> sum;
  set_zero(sum);
  const auto ij = gather_pair<double, 2>(Smoothing<CubicSpline, 2>(CubicSpline{}), p.i, seen_from(p.i, p.j));
  term(sum, p.i, p.j, ij);
  // m_j (v_ij x grad W)_z = -m_j v_ij,y dW/dr with e along x; v_ij,y = -3/2; N_2 = 40/(7 pi).
  const double dW = 40 / (7 * M_PI) / 8 * (-3.0 / 8);
  EXPECT_NEAR(sum.curl_v[0], -2 * -1.5 * dW, rounding);
}

}  // namespace
}  // namespace sphk::test
