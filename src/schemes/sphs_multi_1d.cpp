#include "src/schemes/instantiate.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

Instantiations sphs_multi_1d() {
  return instantiate<SphsMulti, 1>("sphs", "entropy", List<>{});
}

}  // namespace sphk
