#include "src/schemes/core_loops.hpp"
#include "src/schemes/sph.hpp"

namespace sphk {

[[gnu::used]] static const auto space = density_loops<SphEntropy, 3>(List<CubicSpline, CoreTriangle, Hoct<4>>{});

}  // namespace sphk
