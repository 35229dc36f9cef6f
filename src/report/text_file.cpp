#include "src/report/text_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "src/engine/errors.hpp"

namespace sphk {

void write_text(const std::filesystem::path& path, std::string_view text) {
  const auto fail = [&] {
    const char* reason = errno != 0 ? std::strerror(errno) : "unknown reason";
    throw InputError(
        fmt::format("cannot write {}: {}; is there space, and may you write there?", path.string(), reason));
  };
  std::error_code error;
  if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
    throw InputError(fmt::format("cannot write {}: a directory or a device of this name is in the way; choose another",
                                 path.string()));
  std::filesystem::path temporary = path;
  temporary += ".tmp";
  errno = 0;
  std::ofstream file(temporary, std::ios::binary);
  file << text;
  file.close();
  if (!file) fail();
  std::filesystem::rename(temporary, path, error);
  if (error) errno = error.value(), fail();
}

}  // namespace sphk
