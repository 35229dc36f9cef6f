// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/number_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdlib.h>

#include <bit>
#include <fstream>

#include "src/engine/errors.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

/// What stands before the numbers: version 1.0 of NumPy's format, a multiple of 64 bytes long.
std::string npy_header(std::size_t bytes, const std::vector<std::size_t>& shape) {
  std::string text = fmt::format("{{'descr': '{}f{}', 'fortran_order': False, 'shape': ({},), }}",
                                 std::endian::native == std::endian::little ? '<' : '>', bytes, fmt::join(shape, ", "));
  constexpr std::size_t magic = 10;
  text += std::string(63 - (magic + text.size()) % 64, ' ') + '\n';
  return std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(text.size() % 256) +
         static_cast<char>(text.size() / 256) + text;
}

}  // namespace

NumberFiles::NumberFiles() {
  std::string name = (fs::temp_directory_path() / "sphk-figures-XXXXXX").string();
  if (!mkdtemp(name.data()))
    throw InputError(
        fmt::format("cannot make a temporary folder in {}: is the disk full? TMPDIR can name another place",
                    fs::temp_directory_path().string()));
  folder_ = name;
}

NumberFiles::~NumberFiles() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

template <class T>
std::string NumberFiles::write(std::span<const T> numbers, const std::vector<std::size_t>& shape) {
  const fs::path path = folder_ / fmt::format("{}.npy", count_++);
  std::ofstream file(path, std::ios::binary);
  const std::string header = npy_header(sizeof(T), shape);
  file.write(header.data(), static_cast<std::streamsize>(header.size()));
  file.write(reinterpret_cast<const char*>(numbers.data()), static_cast<std::streamsize>(numbers.size_bytes()));
  file.close();
  if (!file)
    throw InputError(fmt::format("cannot write {}: is the disk full? TMPDIR can name another place", path.string()));
  return path.string();
}

std::string NumberFiles::add(std::span<const double> numbers, const std::vector<std::size_t>& shape) {
  return write(numbers, shape.empty() ? std::vector{numbers.size()} : shape);
}

std::string NumberFiles::add_image(std::span<const double> numbers, const std::vector<std::size_t>& shape) {
  std::vector<float> single(numbers.size());
  for (std::size_t k = 0; k < numbers.size(); ++k) single[k] = static_cast<float>(numbers[k]);
  return write(std::span<const float>(single), shape);
}

}  // namespace sphk
