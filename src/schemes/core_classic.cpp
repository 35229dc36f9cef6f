#include "src/schemes/classic.hpp"
#include "src/schemes/core_loops.hpp"

namespace sphk {

[[gnu::used]] static const auto line = density_loops<1, ClassicCore, ClassicDensity>(List<>{});
[[gnu::used]] static const auto plane = density_loops<2, ClassicCore, ClassicDensity>(List<CubicSpline>{});
[[gnu::used]] static const auto space =
    density_loops<3, ClassicCore, ClassicDensity>(List<CubicSpline, CoreTriangle, Hoct<4>>{});

}  // namespace sphk
