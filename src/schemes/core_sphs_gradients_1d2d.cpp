#include "src/schemes/core_loops.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

[[gnu::used]] static const auto line = gradient_loops<Sphs, 1>(List<>{});
[[gnu::used]] static const auto plane = gradient_loops<Sphs, 2>(List<Hoct<4>, WendlandC6>{});

}  // namespace sphk
