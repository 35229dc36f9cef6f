#pragma once

#include <filesystem>
#include <string_view>

namespace sphk {

/// Makes or replaces the file `path` in one go: `bytes` go to a temporary file in the same folder, which is synced to
/// the disk and renamed, so that a crash or a full disk leaves the old file or none, never half of one. Throws
/// InputError when the folder is missing or cannot be written, or the disk is full.
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace sphk
