#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/study/extremes.hpp"

namespace sphk {

/// What was required of a case, and what came out.
struct Outcome {
  std::string required, found;
  bool passed = false;
};

/// Of a run that has finished in this folder. A few steps more, on one thread and on two, must agree.
std::vector<Outcome> outcomes_of(const ExtremeCase& one, const std::filesystem::path& folder);

}  // namespace sphk
