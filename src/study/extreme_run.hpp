// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "src/scenes/scene.hpp"

namespace sphk {

/// A run that has finished.
struct FinishedRun {
  std::filesystem::path folder;  ///< with run.json, history.csv and one snapshot beside the first
  const Scene& scene;
  const Settings& settings;
};

/// A number of a run, and where it comes from if that tells something.
struct Quantity {
  double value = 0;
  std::string where;
};

/// Of history.csv, in its last row: a column ("l1_v", a measure of the scene, ...), or what a column with _drift behind
/// its name holds ("energy", "momentum", "angular_momentum"). Of run.json: "pairs" (of an update, over the neighbour
/// number). Of the last snapshot: "front" (distance of the foremost shock from its place, in support radii of the gas
/// ahead). Of history and snapshot: "unsound" (numbers that are not finite, or not positive where they have to be).
/// Throws InputError where there is no such number.
Quantity quantity_of(const std::string& name, const FinishedRun& run);

/// Largest difference of two snapshots, over the largest number of the same column.
double difference(const std::filesystem::path& one, const std::filesystem::path& other);

}  // namespace sphk
