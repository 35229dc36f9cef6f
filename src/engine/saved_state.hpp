#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace sphk {

/// Everything that a run's next step depends on, bit by bit, in named blocks of bytes; means something to the scheme,
/// particle number and build that it comes from.
using SavedState = std::map<std::string, std::vector<std::uint8_t>>;

}  // namespace sphk
