// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace sphk {

/// All files of the set that `path` belongs to, in order: `path` alone, or x.0.hdf5, x.1.hdf5, ... as many as the
/// Header's NumFilesPerSnapshot says. `path` may be any of the parts, or x.hdf5 or x for the whole set. Throws
/// InputError when a part is missing or no file is found.
std::vector<std::filesystem::path> file_parts(const std::filesystem::path& path);

}  // namespace sphk
