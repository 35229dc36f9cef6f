// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/study/plan.hpp"

namespace sphk {

/// What a study runs and asks, and where to.
struct StudyRequest : StudyQuestions {
  std::string what;             ///< a scene, a study file or a preset
  std::vector<StudyAxis> axes;  ///< of a scene: what differs from point to point
  double max_seconds = 0;       ///< start no further point after so many; 0: no limit
  int threads = 0;              ///< of each run; 0: what OpenMP gives
  std::optional<std::filesystem::path> out, report;
};

/// Error against run time over every combination of schemes, kernels, resolutions, ...: each run is a process of its
/// own. Tells on standard output how far it is and what it found. Leaves study.json (every run, raw), study.csv,
/// study.png and the page that `report` names. A signal stops it (stop_signal.hpp); asked again, it goes on where it
/// was. Throws InputError: before anything runs, where a point's keys are none, nothing measures its error or the
/// points of others cannot be read.
void study(const StudyRequest& request);

}  // namespace sphk
