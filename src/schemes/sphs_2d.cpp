#include "src/schemes/instantiate.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

Instantiations sphs_2d() {
  return instantiate<Sphs, 2>("sphs", "entropy", List<Hoct<4>, WendlandC6>{}, Masses::equal);
}

}  // namespace sphk
