#include "src/schemes/core_loops.hpp"
#include "src/schemes/sph.hpp"

namespace sphk {

[[gnu::used]] static const auto line = density_loops<SphEntropy, 1>(List<>{});
[[gnu::used]] static const auto plane = density_loops<SphEntropy, 2>(List<CubicSpline>{});

}  // namespace sphk
