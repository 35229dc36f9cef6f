#include "src/schemes/core_loops.hpp"

namespace sphk {

[[gnu::used]] static const auto line = gradient_loops<1, SphsConservativeCore>(List<>{});
[[gnu::used]] static const auto plane = gradient_loops<2, SphsConservativeCore>(List<>{});
[[gnu::used]] static const auto space = gradient_loops<3, SphsConservativeCore>(List<Hoct<4>>{});

}  // namespace sphk
