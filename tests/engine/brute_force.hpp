// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "src/engine/particle_set.hpp"
#include "src/engine/simulation.hpp"

namespace sphk::test {

/// The pressure force of EQUATIONS' table: R10 eq 10; R10 eq 17 with phi = rho (S12 eq 7); the gradient of the energy
/// for any masses; Morris (S12 eq 18).
enum class MomentumForm { sph, tsph, conservative, morris };

/// One right-hand side by explicit sums over all pairs and all periodic images, in double and without any of the
/// engine's code but the smoothing kernels' shapes: the independent check of cells, tiles and passes. O(N^2 images).
struct BruteForce {
  std::vector<double> h, rho, n, dn_dh, drho_dh, P, c, balsara, entropy_rate, count;
  std::vector<Array3> a, curl_v;
  std::vector<double> div_v;

  /// Both arguments have to outlive this object.
  BruteForce(const ParticleSet& particles, const SimulationSettings& settings);

  /// An image of j within max(h_i, h_j) of i, i itself included. Where r = 0, e and the derivatives are zero.
  struct Pair {
    int j;
    Array3 e;  ///< (x_i - x_j) / r
    double r;
    double W, dW;       ///< Wbar and Wbar' = dWbar/dr
    double dW_i, dW_j;  ///< dW/dr with h_i and with h_j
  };
  std::vector<Pair> pairs(int i) const;
  double W_own(int i, double r) const { return r < h[i] ? kernel(r, h[i]).W : 0; }  ///< W(r, h_i)
  /// z of the conservative form: d rho_i = sum_j (m_j + z_i) W'(r, h_i) e_ij . d r_ij where h keeps its constraint.
  double z(int i) const;
  /// What j adds to the acceleration of i, along e_ij.
  double pressure_force(MomentumForm form, int i, const Pair& pair) const;

 private:
  struct Neighbour {
    int j;
    Array3 r_ij;  ///< x_i - x_j of one image
    double r;
  };
  struct Kernel {
    double W, dW_dr, dW_dh;
  };
  Kernel kernel(double r, double h) const;
  std::vector<Neighbour> images(int i, double reach) const;
  double root_of_constraint(int i) const;
  void gather_sums(int i);
  void state_equation(int i);
  void pair_sums(int i);

  const ParticleSet& particles_;
  const SimulationSettings& settings_;
};

/// n particles per axis on a lattice that is shaken by `jitter` spacings, with uneven masses, velocities and energies.
ParticleSet shaken_lattice(int dimension, Array3 counts, double jitter, bool periodic, unsigned seed);

}  // namespace sphk::test
