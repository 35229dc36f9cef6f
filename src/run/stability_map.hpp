// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace sphk {

/// Linear waves of a kernel and neighbour number on a lattice (R10 sec 3).
struct StabilityRequest {
  std::string kernel, lattice = "cubic";
  double neighbours = 0;  ///< or
  double h = 0;           ///< in spacings; 0: as the neighbour number has it
  double gamma = 5.0 / 3;
  std::optional<std::filesystem::path> out;  ///< folder of the maps
};

/// The slowest waves in lines for people, a verdict, and all neighbour numbers that are stable. Throws InputError, and
/// std::invalid_argument for an unknown kernel.
std::string stability_text(const StabilityRequest& request);

/// stability.csv and stability.png, maps over wave number and support radius, in the folder that is asked for.
void write_stability_map(const StabilityRequest& request);

}  // namespace sphk
