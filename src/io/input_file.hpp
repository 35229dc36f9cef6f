// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace sphk {

/// Throws InputError unless there is a file of that name: not where it is a folder, nor a pipe or a device, which might
/// never end.
void require_file(const std::filesystem::path& path);

}  // namespace sphk
