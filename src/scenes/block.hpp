// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "src/engine/particle_set.hpp"

namespace sphk {

using GridCounts = std::array<int, 3>;

/// A box of evenly spread particles: counts[k] of them along axis k; axes beyond the dimension count 1.
struct Block {
  int dimension = 3;
  GridCounts counts{1, 1, 1};
  Array3 lower{0, 0, 0};
  Array3 size{1, 1, 1};

  std::size_t particles() const { return std::size_t(counts[0]) * counts[1] * counts[2]; }
  double volume() const { return size[0] * size[1] * size[2]; }
};

/// counts = n along the first `dimension` axes, 1 along the others.
GridCounts even_counts(int dimension, int n);

/// n particles a side of the box from -half to half along every axis.
Block centred_cube(int dimension, int n, double half);

/// n particles a unit of length along x, from `lower` on, and `across` of the same spacing along the other axes.
Block bar(int dimension, int n, int across, double lower, double length);

/// x modulo size, in [0, size).
double wrapped(double x, double size);

/// Centres of the block's cells; coordinates beyond the dimension are 0.
std::vector<Array3> lattice_points(const Block& block);

/// `arrangement`: cubic | glass | random, as in the key scene.lattice. glass: copies of a glass side by side, stretched
/// to the block, which is relaxed at first use and cached (glass.hpp); in 1D the lattice, which is what relaxes there.
/// random: points anywhere in the block, with equal chance and each for itself. Throws InputError where the counts
/// have no common tile of a glass.
std::vector<Array3> arranged_points(const Block& block, const std::string& arrangement, std::uint64_t seed = 1);

/// Adds such a block of gas at rest, of equal masses and density rho; u is left to the caller.
void add_block(ParticleSet& gas, const Block& block, const std::string& arrangement, double rho = 1,
               std::uint64_t seed = 1);

/// That of density 1 alone, in a box that it fills and that is periodic.
ParticleSet even_gas(const Block& block, const std::string& arrangement, std::uint64_t seed = 1);

}  // namespace sphk
