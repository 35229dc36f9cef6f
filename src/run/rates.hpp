// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/run/problem.hpp"

namespace sphk {

/// One right-hand side of a file's gas, in double precision and at one time-step for all unless `overrides` say other.
struct RatesRequest {
  std::string file;  ///< a snapshot or an initial condition
  std::vector<Override> overrides;
  std::filesystem::path out;   ///< the HDF5 file to write
  bool split = false;          ///< write each term apart as well
  std::string alpha = "auto";  ///< dissipation: auto | file | a number
};

struct RatesResult {
  std::size_t fields = 0, particles = 0;
  std::vector<std::string> warnings;
};

/// Writes the rates in the file's order of particles. Kokkos must be running. Throws InputError.
RatesResult rates(const RatesRequest& request);

}  // namespace sphk
