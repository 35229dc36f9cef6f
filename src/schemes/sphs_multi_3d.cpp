#include "src/schemes/instantiate.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

Instantiations sphs_multi_3d() {
  return instantiate<SphsMulti, 3>("sphs", "entropy", List<Hoct<4>>{});
}

}  // namespace sphk
