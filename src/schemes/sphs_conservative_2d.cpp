#include "src/schemes/instantiate.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

Instantiations sphs_conservative_2d() {
  return instantiate<SphsConservative, 2>("sphs-conservative", "entropy", List<>{});
}

}  // namespace sphk
