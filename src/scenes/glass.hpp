#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "src/scenes/block.hpp"

namespace sphk {

/// Moves particles of a periodic box [0, size) from `start` to where their density is even.
using Relaxer = std::function<std::vector<Array3>(int dimension, const Array3& size, std::vector<Array3> start)>;

/// Glass: irregular positions of even density and without a preferred direction, counts[k] per axis, periodic, in units
/// of the mean spacing (the box is [0, counts)). Relaxed from one random start, then kept in the folder `cache`; a file
/// there that does not hold this glass is replaced. An empty `cache` keeps nothing.
std::vector<Array3> glass(int dimension, const Counts& counts, const Relaxer& relax,
                          const std::filesystem::path& cache);

/// The same by the engine's damped relaxation and with the user's cache folder.
std::vector<Array3> glass(int dimension, const Counts& counts);

/// ${XDG_CACHE_HOME:-$HOME/.cache}/sphk, or empty where neither variable is set.
std::filesystem::path glass_cache();

/// A random start: one particle anywhere in each cell of the lattice, which leaves no trace of the lattice's directions
/// and less long-wave noise than independent places.
std::vector<Array3> glass_start(int dimension, const Counts& counts);

/// The glass whose copies fill a block: along every axis the largest divisor of the count up to 32 (3D) or 64 (2D).
/// Throws InputError where that is below 8 although the count is not.
Counts glass_tile(const Counts& counts, int dimension);

}  // namespace sphk
