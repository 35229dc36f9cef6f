// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace sphk {

/// The folder of the library that holds this code, or of the program where it is linked into that.
std::filesystem::path library_folder();

/// share/sphk beside that folder, in the build tree and where sphk is installed: drawing scripts, studies that have
/// names, glasses.
std::filesystem::path shared_folder();

}  // namespace sphk
