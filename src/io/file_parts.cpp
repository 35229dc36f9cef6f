// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/file_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/engine/errors.hpp"
#include "src/io/hdf5_file.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

/// `path` itself, or the first part of the set that it names.
fs::path first_existing(const fs::path& path) {
  std::error_code error;
  if (fs::exists(path, error)) return path;
  const std::string without_extension = fs::path(path).replace_extension().string();
  for (const std::string& name : {path.string(), without_extension})
    if (const fs::path part = name + ".0.hdf5"; fs::exists(part, error)) return part;
  return path;
}

}  // namespace

std::vector<fs::path> file_parts(const fs::path& path) {
  const fs::path first = first_existing(path);
  const double count = hdf5::File::open(first).group("Header").number_or("NumFilesPerSnapshot", 1);
  if (!(count > 1)) return {first};
  const fs::path stem = first.stem();  // "x.7" of x.7.hdf5
  const std::string number = stem.extension().string();
  if (number.size() < 2 || !std::all_of(number.begin() + 1, number.end(), [](char c) { return c >= '0' && c <= '9'; }))
    throw InputError(
        fmt::format("{}: its Header says that it is one of {:.0f} parts, but its name has no part number; "
                    "name the parts x.0.hdf5, x.1.hdf5, ..., or set NumFilesPerSnapshot to 1",
                    first.string(), count));
  std::vector<fs::path> parts;
  for (int i = 0; i < count; ++i) {
    parts.push_back(first.parent_path() / fmt::format("{}.{}{}", stem.stem().string(), i, first.extension().string()));
    if (std::error_code error; !fs::exists(parts.back(), error))
      throw InputError(fmt::format("{}: this part of a set of {:.0f} files is missing; put all parts into one folder",
                                   parts.back().string(), count));
  }
  return parts;
}

}  // namespace sphk
