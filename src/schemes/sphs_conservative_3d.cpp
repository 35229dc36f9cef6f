#include "src/schemes/instantiate.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

Instantiations sphs_conservative_3d() {
  return instantiate<SphsConservative, 3>("sphs-conservative", "entropy", List<Hoct<4>>{});
}

}  // namespace sphk
