// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sphk {

/// A run of another engine, or of this one elsewhere, as its user reported it.
struct OtherPoint {
  std::string engine;   ///< "SWIFT SPHENIX"
  std::string setting;  ///< neighbours, resolution, ...
  double error = 0;     ///< by the study's norm
  double cpu = 0;       ///< CPU seconds
  std::string machine;  ///< on which they were spent
};

/// Reads a CSV file with the columns engine, setting, error, cpu_seconds, machine, in any order and named in the first
/// line (csv.hpp). Throws InputError with file and line.
std::vector<OtherPoint> read_others(const std::filesystem::path& path);

}  // namespace sphk
