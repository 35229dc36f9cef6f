// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/scenes/scene.hpp"

namespace sphk {

/// An isentropic ball (disc in 2D, slab in 1D) of radius 1 that expands from rest into vacuum, with rho = 1 and speed
/// of sound 1 at its centre at the start:
///
///   rho = R^-D f^(1/(gamma-1)),  f = 1 - r^2/R^2,  v = r R'/R,  P = rho^gamma / gamma.
///
/// Any R(t) meets the continuity equation, as every shell moves in proportion to R. In Euler's equation
/// Dv/Dt = r R''/R, and -(1/rho) dP/dr = -1/(gamma-1) d(rho^(gamma-1))/dr = 2/(gamma-1) R^(-D(gamma-1)) r/R^2, so that
///
///   R'' = 2/(gamma-1) R^(-1-D(gamma-1)),  R'^2 = 4/(D (gamma-1)^2) (1 - R^(-D(gamma-1))),
///
/// of which the second is the energy integral. For D (gamma-1) = 2 the radius is R^2 = 1 + 2/(gamma-1) t^2.
class HomologousExpansion {
 public:
  HomologousExpansion(int dimension, double gamma) : dimension_(dimension), gamma_(gamma) {}

  /// R at time t >= 0; by Runge and Kutta's method of order 4, to 1e-12.
  double outer_radius(double t) const;
  /// R' where the radius is R.
  double outer_speed(double R) const;
  /// The gas at x when the radius is R; beyond it, vacuum.
  GasState at(const Array3& x, double R) const;

 private:
  int dimension_;
  double gamma_;
};

}  // namespace sphk
