// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

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

bool synced_to_disk(int file) {
  return fsync(file) == 0 || errno == EINVAL;  // EINVAL: this file system cannot sync
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

fs::path temporary_of(const fs::path& path) {
  return folder_of(path) / fmt::format(".{}.{}.tmp", path.filename().string(), getpid());
}

int open_new(const fs::path& temporary) {
  unlink(temporary.c_str());  // of a killed process with our number, or a link that somebody put there
  return open(temporary.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
}

/// Each of the steps; false with errno set at the first that fails.
bool write_new(const fs::path& temporary, std::string_view bytes) {
  const int file = open_new(temporary);
  if (file < 0) return false;
  const bool written = write_all(file, bytes) && synced_to_disk(file);
  const int reason = errno;
  const bool closed = close(file) == 0;  // network file systems report a full disk here
  if (!written) errno = reason;
  return written && closed;
}

/// A second name for the file, or its only one where the file system knows no second; false with errno set.
bool name_exclusively(const fs::path& temporary, const fs::path& path) {
  if (link(temporary.c_str(), path.c_str()) == 0) return true;
  if (errno != EPERM && errno != EOPNOTSUPP && errno != ENOSYS) return false;
  return renameat2(AT_FDCWD, temporary.c_str(), AT_FDCWD, path.c_str(), RENAME_NOREPLACE) == 0;
}

}  // namespace

std::optional<std::string> name_of_temporary(std::string_view name) {
  constexpr std::string_view begin = ".", end = ".tmp";
  if (!name.starts_with(begin) || !name.ends_with(end)) return std::nullopt;
  name.remove_suffix(end.size());
  const auto number = name.find_last_not_of("0123456789");
  if (number == 0 || number + 1 == name.size() || name[number] != '.') return std::nullopt;
  return std::string(name.substr(begin.size(), number - begin.size()));
}

std::string text_of_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void sync_to_disk(const fs::path& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool synced = file >= 0 && synced_to_disk(file);
  const std::string reason = std::strerror(errno);
  if (file >= 0) close(file);
  if (!synced) throw InputError(fmt::format("{} cannot be brought to the disk ({})", path.string(), reason));
}

bool make_exclusively(const fs::path& path, std::string_view bytes) {
  const fs::path temporary = temporary_of(path);
  const bool made = write_new(temporary, bytes) && name_exclusively(temporary, path);
  const int reason = errno;
  unlink(temporary.c_str());
  errno = reason;
  return made;
}

NewFile::NewFile(const fs::path& path) : path_(path), temporary_(temporary_of(path)) {
  const fs::path folder = folder_of(path);
  if (std::error_code error; !fs::is_directory(folder, error))
    throw InputError(
        fmt::format("{0}: there is no folder {1}; make it with: mkdir -p {1}", path.string(), folder.string()));
  if (std::error_code error; fs::exists(path, error) && !fs::is_regular_file(path, error))
    throw InputError(
        fmt::format("{}: a directory or a device of this name is in the way; choose another name", path.string()));
  file_ = open_new(temporary_);
  if (file_ < 0)
    throw InputError(
        fmt::format("{}: it cannot be written ({}); choose another folder", path.string(), std::strerror(errno)));
}

NewFile::~NewFile() {
  close(file_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void NewFile::complete() {
  struct stat facts {};
  fstat(file_, &facts);
  // Network file systems report a full disk when a file is closed, of whichever of its descriptors.
  const int copy = synced_to_disk(file_) ? dup(file_) : -1;
  if (copy < 0 || close(copy) != 0 || std::rename(temporary_.c_str(), path_.c_str()) != 0)
    fail(static_cast<double>(facts.st_size), errno);
  temporary_.clear();
  if (const int entries = open(folder_of(path_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); entries >= 0) {
    synced_to_disk(entries);  // the new name itself; the data are safe already
    close(entries);
  }
}

void NewFile::fail(double bytes, int reason) const {
  throw InputError(fmt::format("{}: {:.3g} MB cannot be written ({}); make room or choose another folder",
                               path_.string(), bytes / 1e6, std::strerror(reason)));
}

void write_atomically(const fs::path& path, std::string_view bytes) {
  NewFile file(path);
  if (!write_all(file.descriptor(), bytes)) file.fail(static_cast<double>(bytes.size()), errno);
  file.complete();
}

}  // namespace sphk
