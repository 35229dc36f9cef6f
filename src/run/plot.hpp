#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sphk {

/// What to draw of which runs. At most one of conservation, errors and profile: a figure for all of them together.
struct PlotRequest {
  std::vector<std::string> what;             ///< a run's folder or a snapshot; several: their maps side by side
  std::optional<std::filesystem::path> out;  ///< file of the only figure, or folder of several
  bool exact = true, every = false, conservation = false, errors = false;
  std::string profile;  ///< the field of several runs that is drawn a panel each; empty: none
};

/// Draws PNG files through the script of plot_script.hpp, which prints their names. Throws InputError.
void plot(const PlotRequest& request);

}  // namespace sphk
