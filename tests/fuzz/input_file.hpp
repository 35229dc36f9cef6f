// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "src/engine/errors.hpp"

namespace sphk {

/// A file in memory that holds one input; it goes with the process.
class InputFile {
 public:
  explicit InputFile(const std::string& suffix) : path_("/dev/shm/sphk-fuzz-" + std::to_string(getpid()) + suffix) {}
  ~InputFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  const std::filesystem::path& path() const { return path_; }
  void put(const std::uint8_t* data, std::size_t size) const {
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  }

 private:
  std::filesystem::path path_;
};

/// Runs `call`; an InputError with a message is a good answer to a bad file, anything else is a finding.
void expect_input_error_or_none(auto call) {
  try {
    call();
  } catch (const InputError& error) {
    if (std::string(error.what()).empty()) __builtin_trap();
  }
}

}  // namespace sphk
