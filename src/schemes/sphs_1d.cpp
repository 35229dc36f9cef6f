#include "src/schemes/instantiate.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

Instantiations sphs_1d() {
  return instantiate<Sphs, 1>("sphs", "entropy", List<>{}, Masses::equal);
}

}  // namespace sphk
