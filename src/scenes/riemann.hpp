// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace sphk {

/// One side of a shock tube: density, velocity along the tube, pressure.
struct TubeState {
  double rho = 0, v = 0, P = 0;
};

/// Exact solution of the Riemann problem of an ideal gas (Toro 2009, ch. 4): the jump lies at x = 0 at t = 0.
class RiemannSolution {
 public:
  /// Throws InputError for densities or pressures that are not positive and for states that part so fast that a vacuum
  /// opens between them (Toro eq 4.82).
  RiemannSolution(const TubeState& left, const TubeState& right, double gamma);

  /// The state on the ray x/t = xi. A point on a jump belongs to the right of it.
  TubeState at(double xi) const;

  /// Pressure and velocity between the waves, and the densities left and right of the contact.
  double P_star() const { return P_star_; }
  double v_star() const { return v_star_; }
  double rho_star_left() const { return rho_star(left_); }
  double rho_star_right() const { return rho_star(right_); }
  /// Speeds x/t of the outer waves: a shock, or the head of a rarefaction.
  double left_front() const { return front(left_); }
  double right_front() const { return front(right_); }

 private:
  /// One side with the direction in which its wave runs: -1 left, +1 right.
  struct Side {
    TubeState state;
    double direction, c;
  };
  double velocity_change(const Side& side, double P, double& slope) const;
  double solve_P_star() const;
  double rho_star(const Side& side) const;
  double front(const Side& side) const;
  TubeState behind(const Side& side, double xi) const;

  double gamma_;
  Side left_, right_;
  double P_star_ = 0, v_star_ = 0;
};

}  // namespace sphk
