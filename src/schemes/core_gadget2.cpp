#include "src/schemes/core_loops.hpp"
#include "src/schemes/gadget2.hpp"

namespace sphk {

[[gnu::used]] static const auto line = density_loops<Gadget2, 1>(List<>{});
[[gnu::used]] static const auto plane = density_loops<Gadget2, 2>(List<CubicSpline>{});
[[gnu::used]] static const auto space = density_loops<Gadget2, 3>(List<CubicSpline, WendlandC6>{});

}  // namespace sphk
