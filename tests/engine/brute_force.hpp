#pragma once

#include <string>
#include <vector>

#include "src/engine/particle_set.hpp"
#include "src/engine/simulation.hpp"

namespace sphk::test {

/// One right-hand side by explicit sums over all pairs and all periodic images, in double and without any of the
/// engine's code but the smoothing kernels' shapes: the independent check of cells, tiles and passes. O(N^2 images).
struct BruteForce {
  std::vector<double> h, rho, n, dn_dh, drho_dh, P, c, balsara, entropy_rate, count;
  std::vector<Array3> a, curl_v, E0;
  std::vector<double> div_v;

  BruteForce(const ParticleSet& particles, const SimulationSettings& settings);

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
