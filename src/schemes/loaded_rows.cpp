// SPDX-License-Identifier: BSD-3-Clause

// Schemes as shared objects beside the library: NAME_2d.so and so on, in the folder sphk.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "src/engine/errors.hpp"
#include "src/engine/places.hpp"
#include "src/schemes/compiled.hpp"
#include "src/schemes/shared_object.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

fs::path module_folder() {
  return library_folder() / "sphk";
}

/// In a build folder, how modules are compiled; nothing elsewhere.
std::string build_command(const fs::path& folder) {
  std::string command;
  std::ifstream in(folder / "build_command.txt");
  std::getline(in, command);
  return command;
}

/// One process at a time builds in a folder; the others wait, and find what they want.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder) : file_(open((folder / "lock").c_str(), O_CREAT | O_RDWR, 0644)) {
    flock(file_, LOCK_EX);
  }
  ~FolderLock() { close(file_); }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_;
};

void build(const fs::path& folder, const std::string& name, const std::string& command) {
  const FolderLock lock(folder);
  if (fits_this_build(folder / (name + ".so"))) return;
  const fs::path log = folder / (name + ".log");
  fmt::print(stderr, "sphk: compiling {}, once (20 s to a minute on two cores)\n", name);
  const std::string line = fmt::format("{} {} </dev/null >'{}' 2>&1", command, name, log.string());
  if (std::system(line.c_str()) != 0)
    throw InputError(fmt::format("{} could not be compiled; its log {} says why", name, log.string()));
}

}  // namespace

Instantiations rows_of_build(const std::string& scheme, int dimension) {
  std::string name = fmt::format("{}_{}d", scheme, dimension);
  std::ranges::replace(name, '-', '_');
  const fs::path folder = module_folder(), file = folder / (name + ".so");
  if (const std::string command = build_command(folder); !command.empty() && !fits_this_build(file))
    build(folder, name, command);
  if (!fs::exists(file))
    throw InputError(fmt::format("{} is not there: this sphk was installed without the scheme {} in {}D", file.string(),
                                 scheme, dimension));
  const auto fill = SharedObject(file).function<void(Instantiations&)>("sphk_rows");
  Instantiations rows;
  fill(rows);
  return rows;
}

}  // namespace sphk
