#pragma once

#include "src/cli/trials.hpp"

namespace sphk {

/// Of a run that has finished in this folder. A few steps more, on one thread and on two, must agree.
std::vector<Outcome> outcomes_of(const ExtremeCase& one, const std::filesystem::path& folder);

}  // namespace sphk
