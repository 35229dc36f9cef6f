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

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

bool sync_to_disk(int file) {
  return fsync(file) == 0 || errno == EINVAL;  // EINVAL: this file system cannot sync
}

/// Each of the steps; false with errno set at the first that fails.
bool replace(const fs::path& path, const fs::path& temporary, std::string_view bytes) {
  unlink(temporary.c_str());  // of a killed process with our number, or a link that somebody put there
  const int file = open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) return false;
  const bool written = write_all(file, bytes) && sync_to_disk(file);
  const int reason = errno;
  const bool closed = close(file) == 0;  // network file systems report a full disk here
  if (!written) errno = reason;
  return written && closed && std::rename(temporary.c_str(), path.c_str()) == 0;
}

}  // namespace

void write_atomically(const fs::path& path, std::string_view bytes) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (std::error_code error; !fs::is_directory(folder, error))
    throw InputError(
        fmt::format("{0}: there is no folder {1}; make it with: mkdir -p {1}", path.string(), folder.string()));
  if (std::error_code error; fs::exists(path, error) && !fs::is_regular_file(path, error))
    throw InputError(
        fmt::format("{}: a directory or a device of this name is in the way; choose another name", path.string()));
  const fs::path temporary = folder / fmt::format(".{}.{}.tmp", path.filename().string(), getpid());
  if (!replace(path, temporary, bytes)) {
    const std::string reason = std::strerror(errno);
    unlink(temporary.c_str());
    throw InputError(fmt::format("{}: {:.3g} MB cannot be written ({}); make room or choose another folder",
                                 path.string(), static_cast<double>(bytes.size()) / 1e6, reason));
  }
  if (const int entries = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); entries >= 0) {
    sync_to_disk(entries);  // the new name itself; the data are safe already
    close(entries);
  }
}

}  // namespace sphk
