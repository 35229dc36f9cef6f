#include "src/io/file_parts.hpp"

#include <fmt/format.h>

#include <regex>

#include "src/engine/errors.hpp"
#include "src/io/hdf5_file.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

/// `path` itself, or the first part of the set that it names.
fs::path first_existing(const fs::path& path) {
  std::error_code error;
  if (fs::exists(path, error)) return path;
  const fs::path without = fs::path(path).replace_extension();
  for (const fs::path& each : {fs::path(without.string() + ".0.hdf5"), fs::path(path.string() + ".0.hdf5")})
    if (fs::exists(each, error)) return each;
  return path;
}

double number_of_parts(const fs::path& path) {
  const hdf5::File file = hdf5::File::open(path);
  const hdf5::Group header = file.group("Header");
  if (!header.has_attribute("NumFilesPerSnapshot")) return 1;
  const auto values = header.numbers("NumFilesPerSnapshot");
  return values.empty() ? 1 : values[0];
}

}  // namespace

std::vector<fs::path> file_parts(const fs::path& path) {
  const fs::path first = first_existing(path);
  const double count = number_of_parts(first);
  if (!(count > 1)) return {first};
  static const std::regex pattern(R"((.*)\.(\d+)\.(hdf5|h5))");
  std::smatch match;
  const std::string name = first.filename().string();
  if (!std::regex_match(name, match, pattern))
    throw InputError(fmt::format("{}: its Header says that it is one of {:.0f} parts, but its name has no part number; "
                                 "name the parts x.0.hdf5, x.1.hdf5, ..., or set NumFilesPerSnapshot to 1",
                                 first.string(), count));
  std::vector<fs::path> parts;
  for (int i = 0; i < count; ++i) {
    parts.push_back(first.parent_path() / fmt::format("{}.{}.{}", match[1].str(), i, match[3].str()));
    if (std::error_code error; !fs::exists(parts.back(), error))
      throw InputError(fmt::format("{}: this part of a set of {:.0f} files is missing; put all parts into one folder",
                                   parts.back().string(), count));
  }
  return parts;
}

}  // namespace sphk
