#pragma once

#include <string>
#include <vector>

#include "src/study/extremes.hpp"

namespace sphk {

/// An arrangement of the scene `odd`, and its runs: gadget2 and sphs, with a global step and with steps of the
/// particles' own.
struct OddArrangement {
  std::string name, setup;
  std::vector<ExtremeCase> cases;
};

const std::vector<OddArrangement>& odd_arrangements();

}  // namespace sphk
