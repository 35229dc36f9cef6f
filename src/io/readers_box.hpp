// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <vector>

#include "src/engine/particle_set.hpp"
#include "src/io/hdf5_file.hpp"

namespace sphk {

/// The box as readers of SWIFT's files know it: [0, size) along each of three axes, and all axes are periodic or none
/// is. What the gas does not fill of a plane or a line it lies in the middle of, so that a slice through the box's
/// centre and a projection show it, once.
struct ReadersBox {
  Array3 size{1, 1, 1};
  Array3 shift{};                                  ///< from the run's coordinates to the readers'
  std::array<bool, 3> wraps{false, false, false};  ///< axes along which all images are one place
  bool periodic = false;                           ///< what readers are told
  /// Where readers see what is at x.
  Array3 placed(const Array3& x) const;
};

/// Along a periodic axis it is the run's box; along an open one it holds the run's and every particle's support, so
/// that readers which take the box for periodic see no image.
ReadersBox readers_box(const Snapshot& snapshot);

/// The same without a shift: for files whose coordinates are to be those of the run.
ReadersBox unshifted_box(const Snapshot& snapshot);

/// The points that ParaView shows: the run's own coordinates, in the middle of the axes that the gas does not fill.
/// Empty where these are what readers see anyway.
std::vector<double> true_points(const Snapshot& snapshot, const ReadersBox& box);

/// Turns what readers see of a file that sphk has written into the run's own coordinates, to the last bit; in rows that
/// somebody has changed since, by the shift. Leaves those of other files.
void undo_shift(const hdf5::File& file, std::span<Array3> x);

}  // namespace sphk
