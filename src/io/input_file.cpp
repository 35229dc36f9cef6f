// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/input_file.hpp"

#include "src/engine/errors.hpp"

namespace sphk {

namespace fs = std::filesystem;

void require_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw InputError(path.string() + ": there is no such file: is the path right?");
  if (fs::is_directory(status)) throw InputError(path.string() + ": this is a folder, not a file; name a file in it");
  if (!fs::is_regular_file(status))
    throw InputError(path.string() + ": this is a pipe or a device; copy what it gives into a file and name that");
}

}  // namespace sphk
