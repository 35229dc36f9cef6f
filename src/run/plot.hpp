// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/run/plot_targets.hpp"

namespace sphk {

/// What to draw of which runs. At most one of conservation, errors, profile and a field: a figure for all of them
/// together.
struct PlotRequest {
  std::vector<std::string> what;             ///< a run's folder or a snapshot; several: their maps side by side
  std::optional<std::filesystem::path> out;  ///< file of the only figure, or folder of several
  bool exact = true, every = false, conservation = false, errors = false;
  std::string profile;  ///< the field that is drawn along the scene's coordinate, a panel a run; empty: none
  FieldView view;       ///< its field is drawn as a map of each run, or of every snapshot of one; scale of profile too
};

/// Draws figures (PNG where no other ending is asked for) through the scripts of plot_script.hpp, which print their
/// names. Kokkos must be running. Throws InputError.
void plot(const PlotRequest& request);

}  // namespace sphk
