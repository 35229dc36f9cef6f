#include "src/schemes/instantiate.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

Instantiations sphs_conservative_1d() {
  return instantiate<SphsConservative, 1>("sphs-conservative", "entropy", List<>{});
}

}  // namespace sphk
