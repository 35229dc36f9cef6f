#include "src/schemes/core_loops.hpp"

namespace sphk {

[[gnu::used]] static const auto line = gradient_loops<1, SphsCore>(List<>{});
[[gnu::used]] static const auto plane = gradient_loops<2, SphsCore>(List<Hoct<4>, WendlandC6>{});
[[gnu::used]] static const auto space = gradient_loops<3, SphsCore>(List<Hoct<4>, WendlandC2, BSpline<5>, Liq>{});

}  // namespace sphk
