#include "src/schemes/instantiate.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

Instantiations sphs_multi_2d() {
  return instantiate<SphsMulti, 2>("sphs", "entropy", List<Hoct<4>, WendlandC6>{});
}

}  // namespace sphk
