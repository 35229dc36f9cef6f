#include "src/schemes/instantiate.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

Instantiations sphs_3d() {
  return instantiate<Sphs, 3>("sphs", "entropy", List<Hoct<4>>{}, Masses::equal);
}

}  // namespace sphk
