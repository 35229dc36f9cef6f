#include "src/schemes/classic.hpp"
#include "src/schemes/core_loops.hpp"

namespace sphk {

[[gnu::used]] static const auto line = density_loops<1, Gadget2Core, ClassicDensity>(List<>{});
[[gnu::used]] static const auto plane = density_loops<2, Gadget2Core, ClassicDensity>(List<CubicSpline, Liq>{});
[[gnu::used]] static const auto space = density_loops<3, Gadget2Core, ClassicDensity>(List<CubicSpline, WendlandC6>{});

}  // namespace sphk
