#pragma once

#include <string>
#include <vector>

#include "src/study/points.hpp"

namespace sphk {

/// A study that has a name: what the papers show, and questions that users ask.
struct StudyPreset {
  std::string name, summary, scene, norm;
  double target = 0;
  std::vector<StudyPoint> points;
  std::vector<std::pair<std::string, std::string>> fixed{};  ///< keys of all points
};

const std::vector<StudyPreset>& study_presets();

}  // namespace sphk
