// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace sphk {

// Sentences on choices that cannot be meant, empty where there is nothing to say. They are about particles on a
// lattice, cubic in 3D, square in 2D, and do not look at supports wider than widest_support spacings.

/// Do particles of this kernel and neighbour number leave the lattice?
std::string stability_remark(const std::string& kernel, double neighbours, int dimension, double gamma);

/// A smoothing kernel with its neighbour number, and what is usual in its place.
struct KernelPair {
  std::string kernel;
  double neighbours;
};

/// The density that they measure where it is 1 (S12 Table 1), the support being that of so many neighbours at the
/// measured density (S12 eq 11).
double lattice_density(const KernelPair& pair, int dimension);
/// Is that off by more than 3 %? `usual`: a better pair.
std::string sampling_remark(const KernelPair& pair, const KernelPair& usual, int dimension);

/// The Courant number C of dt = C h / (2 c) above which the fastest sound wave of the lattice grows in a leapfrog,
/// omega dt = 2, less a fifth: the waves are those of fixed supports, and those that follow the density stiffen them.
double largest_courant(const KernelPair& pair, int dimension, double gamma);
/// Is the Courant number above it?
std::string courant_remark(double courant, const KernelPair& pair, int dimension, double gamma);

}  // namespace sphk
