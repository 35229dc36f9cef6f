// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/run/plot_targets.hpp"

namespace sphk {

/// A film of runs, side by side.
struct MovieRequest {
  std::vector<std::string> what;  ///< folders of runs
  std::filesystem::path out;      ///< .mp4, .gif, or a page .html with the pictures in it
  FieldView view;                 ///< one scale of colours for all pictures
  double fps = 24;                ///< pictures a second
  int every = 1;                  ///< snapshot of a run is shown
};

/// Draws the snapshots of the run that has most, beside each those of the other runs that are nearest in time. Kokkos
/// must be running. Throws InputError.
void make_movie(const MovieRequest& request);

}  // namespace sphk
