#include "src/schemes/core_loops.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

[[gnu::used]] static const auto line = gradient_loops<Sphs, 1>(List<>{});
[[gnu::used]] static const auto plane = gradient_loops<Sphs, 2>(List<Hoct<4>, WendlandC6>{});
// With a further slope of the density, where the momentum equation is conservative.
[[gnu::used]] static const auto conservative_line = gradient_loops<SphsConservative, 1>(List<>{});
[[gnu::used]] static const auto conservative_plane = gradient_loops<SphsConservative, 2>(List<>{});

}  // namespace sphk
