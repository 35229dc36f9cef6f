#include "src/schemes/instantiate.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

Instantiations sphs_morris_2d() {
  return instantiate<SphsMorris, 2>("sphs-morris", "entropy", List<>{});
}

}  // namespace sphk
