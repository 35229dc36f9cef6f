// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "src/scenes/scene.hpp"

namespace sphk {

/// Self-similar blast wave of a point (3D), line (2D) or plane (1D) explosion in a cold, even gas (Sedov 1959; Landau &
/// Lifshitz 1987, sec 106). The shock stands at R = (E t^2 / (alpha rho_0))^(1/(D+2)); behind it, with lambda = r/R,
/// rho = rho_0 G, v = dR/dt U, P = rho_0 (dR/dt)^2 Pi.
class SedovSolution {
 public:
  /// Throws InputError unless 1 < gamma < 7 (above, a hole opens in 3D).
  SedovSolution(int dimension, double gamma);

  /// Total energy E in units of rho_0 R^(D+2) / t^2 (of both sides in 1D).
  double alpha() const { return alpha_; }
  /// Shock radius at time t of an explosion of energy E in gas of density rho_0.
  double shock_radius(double E, double rho_0, double t) const;
  /// Density, radial velocity (in v[0]) and pressure at radius r < R; the gas ahead of the shock is the caller's.
  GasState behind_shock(double r, double E, double rho_0, double t) const;

 private:
  struct Profile {
    double G, U, Pi, energy;  ///< energy: integral of (G U^2/2 + Pi/(gamma-1)) lambda^(D-1) from lambda to 1
  };
  Profile slope(double log_lambda, const Profile& y) const;
  void integrate();

  int dimension_;
  double gamma_, alpha_ = 0;
  std::vector<Profile> table_;  ///< at lambda = exp(-k step)
};

}  // namespace sphk
