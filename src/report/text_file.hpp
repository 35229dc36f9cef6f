#pragma once

#include <filesystem>
#include <string_view>

namespace sphk {

/// Writes `text` to `path` through a temporary file beside it and a rename, so that a reader never sees half a file.
/// Throws InputError with the system's reason (folder missing, no permission, disk full).
void write_text(const std::filesystem::path& path, std::string_view text);

}  // namespace sphk
