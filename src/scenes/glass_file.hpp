#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/scenes/block.hpp"

namespace sphk {

/// glass-<D>d-<counts>-v1.bin, such as glass-3d-32x32x32-v1.bin. The version changes with the way glasses are made.
std::string glass_file_name(int dimension, const Counts& counts);

/// The positions in a cached glass; nothing where the file is absent, of another shape, cut short or damaged.
std::optional<std::vector<Array3>> read_glass(const std::filesystem::path& file, int dimension, const Counts& counts);

/// Writes under a temporary name and renames, so that a reader never sees half a file. A folder that cannot be written
/// to costs the next run a relaxation, nothing else, so failures are ignored.
void write_glass(const std::filesystem::path& file, int dimension, const Counts& counts,
                 const std::vector<Array3>& points);

}  // namespace sphk
