// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "src/engine/particle_set.hpp"

namespace sphk {

/// Finds the particle nearest to a place, in a box that is periodic along all its axes, from a grid of cells with about
/// one particle each. The engine's cells answer for its own particles in a run; this asks a snapshot, at any place.
class NearestParticle {
 public:
  static constexpr std::size_t none = ~std::size_t{0};

  /// The snapshot must stay, with its coordinates.
  explicit NearestParticle(const Snapshot& snapshot);
  /// Distance from x to the nearest particle, or to the nearest other one than that of the row `self`.
  double distance(const Array3& x, std::size_t self = none) const;

 private:
  std::size_t cell_of(const std::array<int, 3>& cell) const;
  std::array<int, 3> cell_at(const Array3& x) const;
  double nearest_in(std::size_t cell, const Array3& x, std::size_t self) const;

  int dimension_;
  Box box_;
  std::array<int, 3> counts_{1, 1, 1};
  double edge_;  ///< the shortest of a cell
  std::span<const Array3> x_;
  std::vector<std::uint32_t> first_, rows_;  ///< rows_[first_[cell]] and on: the particles of each cell
};

}  // namespace sphk
