#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sphk {

/// What to draw of which runs. At most one of conservation, errors, profile and map: a figure for all of them together.
struct PlotRequest {
  std::vector<std::string> what;             ///< a run's folder or a snapshot; several: their maps side by side
  std::optional<std::filesystem::path> out;  ///< file of the only figure, or folder of several
  bool exact = true, every = false, conservation = false, errors = false;
  std::string profile;  ///< the field that is drawn along the scene's coordinate, a panel a run; empty: none
  std::string map;      ///< the field that is drawn as a map of each run, or of every snapshot of one; empty: none
  std::vector<double> range;  ///< lowest and highest value that map or profile show; empty: those that there are
  bool logarithmic = false;   ///< of map or profile
};

/// Draws figures (PNG where no other ending is asked for) through the script of plot_script.hpp, which prints their
/// names. Throws InputError.
void plot(const PlotRequest& request);

}  // namespace sphk
