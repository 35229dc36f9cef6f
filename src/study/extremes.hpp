// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "src/run/problem.hpp"

namespace sphk {

/// A number of a run and what it has to be; extreme_run.hpp says which there are.
struct Requirement {
  std::string quantity;
  double below = std::numeric_limits<double>::infinity();
  double above = -std::numeric_limits<double>::infinity();  ///< with neither it is recorded

  bool met_by(double value) const { return value < below && value > above; }
  std::string text() const;
};

/// A stiff or extreme run. Beside its requirements it has to finish.
struct ExtremeCase {
  std::string name;     ///< of a folder as well
  std::string summary;  ///< a few words
  std::string scene;
  KeyTexts keys;
  std::vector<Requirement> requirements;
};

/// Throws InputError where there is no such scene or it cannot run with these keys. What is said of a key begins with
/// its name.
using CheckKeys = std::function<void(const std::string& scene, const KeyTexts& keys)>;

/// Reads a file of cases, a list [[case]]: `name`, `scene`, `summary`, keys under [case.set], written as in a scene
/// file, and bounds under [case.require]: `energy.below = 1e-3`, `nearest.above = 0.7`, or `wall_heating = "recorded"`.
/// What stands above all cases (`scene`, [set], [require]) holds for each that does not say otherwise. Throws
/// InputError with line and caret; scene and keys are checked where `check` is given.
std::vector<ExtremeCase> read_extremes(const std::filesystem::path& path, const CheckKeys& check = {});

/// The cases of all files of a folder, by the files' names.
std::vector<ExtremeCase> extremes_in(const std::filesystem::path& folder, const CheckKeys& check = {});

}  // namespace sphk
