#include "src/schemes/instantiate.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

Instantiations sphs_morris_3d() {
  return instantiate<SphsMorris, 3>("sphs-morris", "entropy", List<Hoct<4>>{});
}

}  // namespace sphk
