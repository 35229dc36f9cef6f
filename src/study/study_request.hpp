#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/study/plan.hpp"

namespace sphk {

/// What a study runs, where to, and what it asks.
struct StudyRequest {
  std::string what;                                        ///< a scene, a study file or a preset
  std::vector<StudyAxis> axes;                             ///< what differs from point to point
  std::vector<std::pair<std::string, std::string>> fixed;  ///< keys of all points
  /// The study file's own where these are empty or zero.
  std::string norm;
  double target = 0;
  std::vector<double> budgets;
  int repeat = 0;
  std::string others;
  double max_seconds = 0;  ///< start no further point after so many; 0: no limit
  int threads = 0;         ///< of each run; 0: what OpenMP gives
  std::optional<std::filesystem::path> out, report;
};

/// What a request comes to: a preset's file, a study file, or the axes, with the request's own choices. Throws
/// InputError where a point's keys are none, nothing measures its error or the points of others cannot be read: before
/// anything runs.
StudyPlan plan_of(const StudyRequest& request);

}  // namespace sphk
