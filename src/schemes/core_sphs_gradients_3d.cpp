#include "src/schemes/core_loops.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

[[gnu::used]] static const auto space = gradient_loops<Sphs, 3>(List<Hoct<4>>{});
// With a further slope of the density, where the momentum equation is conservative.
[[gnu::used]] static const auto conservative_space = gradient_loops<SphsConservative, 3>(List<Hoct<4>>{});

}  // namespace sphk
