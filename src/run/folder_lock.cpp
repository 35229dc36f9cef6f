// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "src/engine/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/report/process.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

/// The processes of this host take and leave the lock of a folder one after another. File systems that cannot do so are
/// served by link() alone.
class OneAtATime {
 public:
  explicit OneAtATime(const fs::path& folder) : folder_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    while (folder_ >= 0 && flock(folder_, LOCK_EX) != 0 && errno == EINTR) {
    }
  }
  ~OneAtATime() {
    if (folder_ >= 0) close(folder_);
  }
  OneAtATime(const OneAtATime&) = delete;
  OneAtATime& operator=(const OneAtATime&) = delete;

 private:
  int folder_;
};

std::string first_line(const fs::path& path) {
  std::string line;
  std::ifstream file(path);
  std::getline(file, line);
  return line;
}

LockOwner this_process() {
  std::error_code none;
  return {.host = host_name(),
          .process = getpid(),
          .start = start_of_process(getpid()),
          .boot = first_line("/proc/sys/kernel/random/boot_id"),
          .numbered = fs::read_symlink("/proc/self/ns/pid", none).string()};
}

std::string text_of(const LockOwner& owner) {
  return Json{{"host", owner.host},
              {"process", owner.process},
              {"start", owner.start},
              {"boot", owner.boot},
              {"numbered", owner.numbered}}
             .dump(-1, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

/// Nothing where the file is no lock.
std::optional<LockOwner> owner_of(const fs::path& lock) {
  try {
    if (!fs::is_regular_file(fs::symlink_status(lock))) return std::nullopt;
    const Json json = Json::parse(text_of_file(lock));
    return LockOwner{.host = json.at("host"),
                     .process = json.at("process"),
                     .start = json.at("start"),
                     .boot = json.at("boot"),
                     .numbered = json.at("numbered")};
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

/// Is it a process of this host that runs no more? One that cannot be asked may still run.
bool is_dead(const LockOwner& owner) {
  const LockOwner self = this_process();
  if (owner.host != self.host) return false;
  if (owner.boot != self.boot) return true;
  if (owner.numbered != self.numbered) return false;
  const bool there = kill(static_cast<pid_t>(owner.process), 0) == 0 || errno == EPERM;
  return !there || start_of_process(static_cast<pid_t>(owner.process)) != owner.start;
}

void refuse_living(const fs::path& folder) {
  const fs::path lock = folder / FolderLock::file_name;
  if (!fs::exists(fs::symlink_status(lock))) return;
  const std::optional<LockOwner> owner = owner_of(lock);
  if (!owner)
    throw InputError(fmt::format("{}: what stands here is no lock of sphk; remove it where no run of {} goes on",
                                 lock.string(), folder.string()));
  if (!is_dead(*owner))
    throw InputError(
        fmt::format("{} belongs to the run of process {} on {}: wait for its end, or name another folder "
                    "with --out; where that process runs no more, remove {}",
                    folder.string(), owner->process, owner->host, lock.string()));
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder) : folder_(fs::absolute(folder)) {
  const OneAtATime guard(folder_);
  const fs::path lock = folder_ / file_name;
  refuse_living(folder);
  fs::remove(lock);  // of a dead process
  if (make_exclusively(lock, text_of(this_process()))) return;
  const std::string reason = std::strerror(errno);
  refuse_living(folder);  // of another host, this moment
  throw InputError(fmt::format("{} cannot be written ({}): choose another place with --out", lock.string(), reason));
}

FolderLock::FolderLock(FolderLock&& other) noexcept : folder_(std::move(other.folder_)) {
  other.folder_.clear();
}

FolderLock::~FolderLock() {
  if (folder_.empty()) return;
  const OneAtATime guard(folder_);
  const fs::path lock = folder_ / file_name;
  std::error_code none;
  if (text_of_file(lock) == text_of(this_process())) fs::remove(lock, none);
}

void FolderLock::refuse_locked(const fs::path& folder) {
  refuse_living(folder);
}

}  // namespace sphk
