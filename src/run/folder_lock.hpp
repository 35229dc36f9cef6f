// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace sphk {

/// The process that a run's folder belongs to, as the file run.lock in it says.
struct LockOwner {
  std::string host;
  long process = 0;      ///< its number
  std::string start;     ///< when it began, in ticks since the machine did: a number that is used again differs here
  std::string boot;      ///< of the machine
  std::string numbered;  ///< the namespace of its number: containers count their own
};

/// A folder that belongs to this process for as long as this lives, so that no two runs write into it.
class FolderLock {
 public:
  static constexpr const char* file_name = "run.lock";

  /// Takes the folder; so it does where the process that had it has died on this host. Throws InputError that names
  /// host and process where it belongs to another.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&&) = delete;

  /// Throws InputError where the folder belongs to a process, or to one that cannot be asked.
  static void refuse_locked(const std::filesystem::path& folder);

 private:
  std::filesystem::path folder_;  ///< empty: the lock has been moved from here
};

}  // namespace sphk
