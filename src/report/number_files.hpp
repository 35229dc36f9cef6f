// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace sphk {

/// A temporary folder of arrays for the drawing scripts, which goes with this object.
class NumberFiles {
 public:
  /// Throws InputError where there is no room for temporary files.
  NumberFiles();
  ~NumberFiles();
  NumberFiles(const NumberFiles&) = delete;
  NumberFiles& operator=(const NumberFiles&) = delete;

  /// The file, in NumPy's format, of the next array; `shape` is empty for one as long as it is. Throws InputError.
  std::string add(std::span<const double> numbers, const std::vector<std::size_t>& shape = {});
  /// The same in single precision, for pictures.
  std::string add_image(std::span<const double> numbers, const std::vector<std::size_t>& shape);

 private:
  template <class T>
  std::string write(std::span<const T> numbers, const std::vector<std::size_t>& shape);

  std::filesystem::path folder_;
  std::size_t count_ = 0;
};

}  // namespace sphk
