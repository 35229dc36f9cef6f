#include "src/schemes/core_loops.hpp"

namespace sphk {

[[gnu::used]] static const auto line = density_loops<1, SphsCore, TermSet<>>(List<>{});
[[gnu::used]] static const auto plane = density_loops<2, SphsCore, TermSet<>>(List<Hoct<4>, WendlandC6>{});
[[gnu::used]] static const auto space =
    density_loops<3, SphsCore, TermSet<>>(List<Hoct<4>, WendlandC2, BSpline<5>, Liq>{});
[[gnu::used]] static const auto conservative_line = density_loops<1, SphsConservativeCore, TermSet<>>(List<>{});
[[gnu::used]] static const auto conservative_plane = density_loops<2, SphsConservativeCore, TermSet<>>(List<>{});
[[gnu::used]] static const auto conservative_space = density_loops<3, SphsConservativeCore, TermSet<>>(List<Hoct<4>>{});

}  // namespace sphk
