#pragma once

#include <filesystem>
#include <functional>

namespace sphk {

/// Makes or replaces `path` in one go: `write` fills a temporary file in the same folder, which is then synced to the
/// disk and renamed, so that a crash leaves the old file or none, never half of one. The temporary file is removed when
/// anything fails. Throws InputError when the folder is missing or not writable; errors of `write` pass through.
void write_atomically(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path& temporary)>& write);

}  // namespace sphk
