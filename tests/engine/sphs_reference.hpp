// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "tests/engine/brute_force.hpp"

namespace sphk::test {

/// What accompanies an exchange of mass: S12 eq 39-40; S12 eq E6, E8; the donor's velocity and energy.
enum class MassForm { s12, appendix_e, donor };

/// Which dissipation the Balsara factor (S12 eq 32) limits.
enum class BalsaraOn { everything, viscosity, nothing };

struct SphsOptions {
  MomentumForm momentum = MomentumForm::tsph;  ///< tsph is S12 eq 7
  MassForm mass = MassForm::donor;
  bool pay_for_density = true;  ///< the exchange also pays for the density that it changes
  BalsaraOn balsara = BalsaraOn::everything;
  double alpha_v = 1, alpha_A = 1, alpha_m = 1;  ///< strengths of viscosity, entropy and mass dissipation
  std::vector<double> alpha = {};  ///< the switch's alpha_i, not yet times Balsara; empty: alpha_loc of S12 eq 21
};

/// What one term adds to every particle, per unit time.
struct TermRates {
  std::vector<Array3> dv;
  std::vector<double> du;  ///< of a dissipative term at fixed density; of the pressure P/rho^2 drho/dt by motion
  std::vector<double> dm;
};

/// A sum and the sum of its parts' absolute values, the scale of its rounding.
struct Sum {
  double value = 0, magnitude = 0;
  void add(double part) { value += part, magnitude += std::abs(part); }
};

/// Rates of sum m, sum m v and sum m (v^2/2 + u).
struct Budget {
  Sum mass, energy;
  std::array<Sum, 3> momentum;
};

/// SPHS (Read & Hayfield 2012) by explicit sums over all pairs and all periodic images, in double: the independent
/// check of its gradients, switch and dissipation. Every vector has one row a particle, in the order of the particles.
/// A particle whose neighbours do not determine the fit has a meaningless one; `condition` tells.
struct SphsReference {
  BruteForce gas;                        ///< h, rho, n, P, c and so on; its own a, div_v, balsara are not SPHS's
  std::vector<double> A;                 ///< P / rho^gamma
  std::vector<double> div_v, condition;  ///< condition number of the moment matrix of S12 eq D5
  std::vector<Array3> curl_v, grad_div_v;
  std::vector<double> alpha_loc, balsara, v_max;
  std::vector<double> alpha_viscous, alpha;  ///< in the viscosity and in the other terms: times Balsara, by the options
  TermRates pressure, viscosity, entropy, mass;
  std::vector<double> mass_drho;     ///< sum_j dm_j/dt W(r_ij, h_i): the density that the exchange of mass adds
  std::vector<Array3> a;             ///< sums over all terms
  std::vector<double> dA_dt, dm_dt;  ///< sums over all terms

  /// The first two arguments have to outlive this object.
  SphsReference(const ParticleSet& particles, const SimulationSettings& settings, SphsOptions options = {});

  /// At fixed density but for the pressure, whose du is that of the moving particles.
  Budget budget(const TermRates& term) const;
  /// Rate of the energy by the exchange of mass, the work of the density that it changes included.
  Sum energy_of_exchange() const;

 private:
  void fit_velocity(int i);
  void set_switch(int i);
  void pressure_and_viscosity(int i);
  void entropy_dissipation(int i);
  void mass_exchange(int i);
  void density_of_exchange(int i);
  void sum_terms(int i);
  /// (alpha_ij v_sig^p L_ij / rho_ij) Wbar' of S12 eq 33 and 36: negative.
  double exchange(int i, const BruteForce::Pair& pair) const;
  double approach(int i, const BruteForce::Pair& pair) const;

  const ParticleSet& particles_;
  const SphsOptions options_;
  const double gamma_;
  std::vector<std::vector<BruteForce::Pair>> pairs_;
};

}  // namespace sphk::test
