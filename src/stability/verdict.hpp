#pragma once

#include "src/stability/dispersion.hpp"

namespace sphk {

/// omega^2/(k^2 c^2) below which a lattice is called unstable. Wide kernels that keep lattices for long have minima of
/// a few times -1e-4 at the shortest waves; kernels that clump are below -2e-3.
inline constexpr double unstable_below = -1e-3;

/// Supports, in spacings, beyond which no lattice is looked at.
inline constexpr double widest_support = 20;

/// The slowest waves over R10's directions.
WaveModes least_waves(const Lattice& lattice, const std::string& kernel, double h, double gamma, int samples);

/// A sentence where particles of this kernel and neighbour number leave a cubic (in 2D square) lattice, else nothing.
std::string stability_remark(const std::string& kernel, double neighbours, int dimension, double gamma);

}  // namespace sphk
