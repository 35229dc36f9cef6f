// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "src/scenes/block.hpp"

namespace sphk {

/// Moves particles of a periodic box [0, size) from `start` to where their density is even.
using Relaxer = std::function<std::vector<Array3>(int dimension, const Array3& size, std::vector<Array3> start)>;

/// Glass: irregular positions of even density and without a preferred direction, counts[k] per axis, periodic, in units
/// of the mean spacing (the box is [0, counts)). Those of the usual scenes come with sphk (src/scenes/glasses); others
/// are relaxed from one random start, then kept in the folder `cache`; a file there that does not hold this glass is
/// replaced. An empty `cache` keeps nothing.
std::vector<Array3> glass(int dimension, const GridCounts& counts, const Relaxer& relax,
                          const std::filesystem::path& cache);

/// The same by the engine's damped relaxation and with the user's cache folder.
std::vector<Array3> glass(int dimension, const GridCounts& counts);

/// ${XDG_CACHE_HOME:-$HOME/.cache}/sphk, or empty where neither variable is set.
std::filesystem::path glass_cache();

/// A random start: one particle anywhere in each cell of the lattice, which leaves no trace of the lattice's directions
/// and less long-wave noise than independent places.
std::vector<Array3> glass_start(int dimension, const GridCounts& counts);

/// The glass whose copies fill a block: along every axis the largest divisor of the count up to 32 (3D) or 64 (2D).
/// Throws InputError where that is below 8 although the count is not.
GridCounts glass_tile(const GridCounts& counts, int dimension);

/// Relaxes particles of equal mass in the periodic box [0, size) by the scheme "glass", motion of an isothermal gas
/// with friction, until the scatter of the density stops falling: below half a per cent, after some 150 steps.
std::vector<Array3> relax_with_engine(int dimension, const Array3& size, std::vector<Array3> start);

/// glass-<D>d-<counts>-v2.bin, such as glass-3d-32x32x32-v2.bin. The version changes with the way glasses are made.
std::string glass_file_name(int dimension, const GridCounts& counts);

/// The positions in a cached glass; nothing where the file is absent, of another shape, cut short or damaged.
std::optional<std::vector<Array3>> read_glass(const std::filesystem::path& file, int dimension,
                                              const GridCounts& counts);

/// Writes under a temporary name and renames, so that a reader never sees half a file. A folder that cannot be written
/// to costs the next run a relaxation, nothing else, so failures are ignored.
void write_glass(const std::filesystem::path& file, int dimension, const GridCounts& counts,
                 const std::vector<Array3>& points);

}  // namespace sphk
