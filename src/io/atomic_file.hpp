// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace sphk {

/// Makes or replaces the file `path` in one go: what is written goes to a temporary file in the same folder, which is
/// synced to the disk and renamed, so that a crash or a full disk leaves the old file or none, never half of one.
class NewFile {
 public:
  /// Throws InputError when the folder is missing or cannot be written.
  explicit NewFile(const std::filesystem::path& path);
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  /// Removes a file that is not complete.
  ~NewFile();

  /// Of the temporary file, open for reading and writing.
  int descriptor() const { return file_; }
  /// The file is complete, and takes its name. Throws InputError.
  void complete();
  /// Throws InputError: the file, of so many bytes, could not be written, errno says why.
  [[noreturn]] void fail(double bytes, int reason) const;

 private:
  std::filesystem::path path_, temporary_;
  int file_;
};

/// The same in one call. Throws InputError when the folder is missing or cannot be written, or the disk is full.
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

/// Makes the file `path` with these bytes, all at once; false with errno set where it is there already (EEXIST) or
/// cannot be made. Of several processes that try, on this host or others, one succeeds.
bool make_exclusively(const std::filesystem::path& path, std::string_view bytes);

/// The bytes of a file; none where it cannot be read.
std::string text_of_file(const std::filesystem::path& path);

/// Returns once what has been written to the file is on the disk. Throws InputError.
void sync_to_disk(const std::filesystem::path& path);

/// The file that a temporary one of this name was to become; nothing where the name is not of that form.
std::optional<std::string> name_of_temporary(std::string_view name);

}  // namespace sphk
