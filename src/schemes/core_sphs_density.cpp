#include "src/schemes/core_loops.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

[[gnu::used]] static const auto line = density_loops<Sphs, 1>(List<>{});
[[gnu::used]] static const auto plane = density_loops<Sphs, 2>(List<Hoct<4>, WendlandC6>{});
[[gnu::used]] static const auto space = density_loops<Sphs, 3>(List<Hoct<4>>{});

}  // namespace sphk
