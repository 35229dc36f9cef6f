#include "src/schemes/instantiate.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

Instantiations sphs_morris_1d() {
  return instantiate<SphsMorris, 1>("sphs-morris", "entropy", List<>{});
}

}  // namespace sphk
