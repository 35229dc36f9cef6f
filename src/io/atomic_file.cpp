#include "src/io/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "src/engine/errors.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

void check_folder(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw InputError(fmt::format("there is no folder {0}; make it with: mkdir -p {0}", folder.string()));
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw InputError(fmt::format("the folder {} cannot be written ({}); choose another one", folder.string(),
                                 std::strerror(errno)));
}

/// Forces `path` (a file, or a folder's entries) to the disk.
void sync_to_disk(const fs::path& path, int flags) {
  const int file = open(path.c_str(), flags | O_CLOEXEC);
  const bool done = file >= 0 && (fsync(file) == 0 || errno == EINVAL);  // EINVAL: this file system has no sync
  const int reason = errno;
  if (file >= 0) close(file);
  if (!done) throw InputError(fmt::format("{} cannot be saved to the disk ({})", path.string(), std::strerror(reason)));
}

}  // namespace

void write_atomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  check_folder(folder);
  const fs::path temporary = folder / fmt::format(".{}.{}.tmp", path.filename().string(), getpid());
  try {
    write(temporary);
    sync_to_disk(temporary, O_RDONLY);
    fs::rename(temporary, path);
    sync_to_disk(folder, O_RDONLY | O_DIRECTORY);
  } catch (const fs::filesystem_error& error) {
    fs::remove(temporary);
    throw InputError(fmt::format("{} cannot be put in place ({})", path.string(), error.code().message()));
  } catch (...) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw;
  }
}

}  // namespace sphk
