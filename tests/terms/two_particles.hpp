// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "kernels/smoothing/cubic_spline.hpp"
#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/entropy_dissipation.hpp"
#include "kernels/terms/pressure_gradient_conservative.hpp"
#include "kernels/terms/pressure_gradient_sph.hpp"
#include "kernels/terms/pressure_gradient_tsph.hpp"
#include "kernels/terms/pressure_work.hpp"
#include "kernels/terms/pressure_work_tsph.hpp"
#include "kernels/terms/signal_velocity.hpp"
#include "kernels/terms/tensile_correction.hpp"
#include "kernels/terms/velocity_gradient.hpp"
#include "kernels/terms/viscosity_gingold_monaghan.hpp"
#include "kernels/terms/viscosity_signal_velocity.hpp"
#include "kernels/terms/viscosity_switched.hpp"

namespace sphk::test {

/// Every field that a pair term reads.
using Everything =
    List<Position, Separation, Distance2, Velocity, Mass, Support, InverseSupport, Density, InverseDensity, Pressure,
         PressureOverDensity2, GradHMass, SoundSpeed, Balsara, ViscosityAlpha, DissipationAlpha, InverseSpacingKernel>;

template <class T, int D>
using Particle = Values<T, D, Everything>;

template <class Term, class T, int D>
using SumsOf = Values<T, D, typename Term::Adds>;

/// j as a neighbour of i.
template <class T, int D>
Particle<T, D> seen_from(const Particle<T, D>& i, Particle<T, D> j) {
  j.r_ij = i.x - j.x;
  j.r2 = dot(j.r_ij, j.r_ij);
  return j;
}

/// The share of the pair in i's sums, for term `Term` and the cubic spline.
template <class Term, class T, int D>
SumsOf<Term, T, D> share(const Particle<T, D>& i, const Particle<T, D>& j, const Given& given = {}) {
  SumsOf<Term, T, D> sum;
  set_zero(sum);
  const Smoothing<CubicSpline, D> smoothing(CubicSpline{});
  const Term term(given);
  const Particle<T, D> neighbour = seen_from(i, j);
  term(sum, i, neighbour, symmetric_pair<T, D>(smoothing, i, neighbour));
  return sum;
}

/// Two unlike particles in D dimensions, distance 3/2 along the first axis, approaching at speed 1.
/// h = 2 and 3 for i and j, so q = 3/4 and 1/2.
template <class T, int D>
struct TwoParticles {
  Particle<T, D> i{}, j{};
  TwoParticles() {
    set_zero(i);
    set_zero(j);
    i.x[0] = T(1.5), j.x[0] = T(0);
    i.v[0] = T(-0.25), j.v[0] = T(0.75);
    if constexpr (D > 1) i.v[1] = T(0.5), j.v[1] = T(2);
    fill(i, 2, 1, 0.5, 0.6, 1, 0.125);
    fill(j, 3, 2, 0.25, 0.9, 0.5, -0.25);
  }
  static void fill(Particle<T, D>& p, double h, double m, double rho, double P, double balsara, double z) {
    p.h = T(h), p.h_inv = T(1 / h), p.m = T(m), p.rho = T(rho), p.rho_inv = T(1 / rho), p.P = T(P);
    p.P_rho2 = T(P / (rho * rho)), p.c = T(std::sqrt(5.0 / 3 * P / rho)), p.balsara = T(balsara), p.z = T(z);
    p.alpha_v = T(0.5 * balsara), p.alpha_d = T(0.75 * balsara);
    p.W_d_inv = T(2 * h);
  }
};

/// dW/dr of the cubic spline in 1D, N = 4/3: 4/3 h^-2 w'(q); w'(3/4) = -6 (1/4)^2 = -3/8, w'(1/2) = -6 (1/2)^2 = -3/2.
inline constexpr double dW_i_1d = 4.0 / 3 / 4 * (-3.0 / 8), dW_j_1d = 4.0 / 3 / 9 * (-3.0 / 2);

}  // namespace sphk::test
