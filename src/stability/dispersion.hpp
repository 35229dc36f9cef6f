// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <string>
#include <vector>

#include "src/engine/particle_set.hpp"

namespace sphk {

/// A regular arrangement with one particle in a unit of length, area or volume: cells spanned by `edges`, each with
/// particles at `basis`.
struct Lattice {
  std::string name;
  int dimension = 3;
  std::array<Array3, 3> edges{};
  std::vector<Array3> basis;
};

/// cubic, bcc, fcc, hcp in 3D; square, hexagonal in 2D; line in 1D.
const std::vector<Lattice>& lattices();
/// Throws InputError that names the lattices.
const Lattice& find_lattice(const std::string& name);

/// omega^2 / (k^2 c^2) of the slowest waves in which the particles of a cell move together along k, or across it, and
/// in which they move against each other: 1 for sound and 0 for what has no restoring force in a continuous medium;
/// negative where particles run away from the lattice. NaN where there is none. In 3D there are two waves across k (R10
/// Figs. 1-3): `transverse` moves as nearly in the x-y plane, `transverse_z` as nearly along z as k lets it.
struct WaveModes {
  double longitudinal = std::numeric_limits<double>::quiet_NaN(), transverse = longitudinal,
         transverse_z = longitudinal, relative = longitudinal;
  double across() const { return std::fmin(transverse, transverse_z); }  ///< the slower one
  /// The least of those that there are.
  double least() const { return std::fmin(std::fmin(longitudinal, across()), relative); }
};
/// The slower ones of two sets of waves.
WaveModes slower(const WaveModes& a, const WaveModes& b);

/// Waves of SPH (R10 eq 10, constant A, h fixed) on a lattice at rest: R10 eq 40-43, for lattices of several particles
/// a cell with their relative motion.
class Dispersion {
 public:
  /// `h`: support radius in units of the mean spacing n^(-1/D). Throws std::invalid_argument for an unknown kernel.
  Dispersion(const Lattice& lattice, const std::string& kernel, double h, double gamma);
  WaveModes at(const Array3& k) const;

 private:
  /// A neighbour: where it is seen from site `of`, what site it is, and there grad W and the Hessian of W as forces
  /// have them, and the gradient by which the density changes: another one, where a kernel's forces are apart from its
  /// W.
  struct Pair {
    int of, site;
    Array3 x, grad, grad_density;
    std::array<Array3, 3> hessian;
  };
  int dimension_, sites_;
  double gamma_, rho_;  ///< rho: the SPH sum on the lattice, for m = 1
  std::vector<Pair> pairs_;
};

/// A direction of wave vectors kappa (1,1,0) and so on, kappa up to pi over the spacing (R10 Fig. 1-3).
struct WaveDirection {
  std::string name;
  Array3 k;
};
std::vector<WaveDirection> wave_directions(int dimension);

/// The slowest waves of a direction, over `samples` values of kappa in (0, pi].
WaveModes slowest_waves(const Dispersion& dispersion, const Array3& direction, int samples);

/// Support radius of N_n neighbours on a lattice: V_D h^D = N_n; and back.
double lattice_support(double neighbours, int dimension);
double lattice_neighbours(double h, int dimension);

/// omega^2/(k^2 c^2) below which a lattice is called unstable. Wide kernels that keep lattices for long have minima of
/// a few times -1e-4 at the shortest waves; kernels that clump are below -2e-3.
inline constexpr double unstable_below = -1e-3;

/// Supports, in spacings, beyond which no lattice is looked at.
inline constexpr double widest_support = 20;

/// The slowest waves over R10's directions.
WaveModes least_waves(const Lattice& lattice, const std::string& kernel, double h, double gamma, int samples);

}  // namespace sphk
