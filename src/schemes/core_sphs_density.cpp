#include "src/schemes/core_loops.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

[[gnu::used]] static const auto line = density_loops<Sphs, 1>(List<>{});
[[gnu::used]] static const auto plane = density_loops<Sphs, 2>(List<Hoct<4>, WendlandC6>{});
[[gnu::used]] static const auto space = density_loops<Sphs, 3>(List<Hoct<4>>{});
// With a further slope of the density, where the momentum equation is conservative.
[[gnu::used]] static const auto conservative_line = density_loops<SphsConservative, 1>(List<>{});
[[gnu::used]] static const auto conservative_plane = density_loops<SphsConservative, 2>(List<>{});
[[gnu::used]] static const auto conservative_space = density_loops<SphsConservative, 3>(List<Hoct<4>>{});

}  // namespace sphk
