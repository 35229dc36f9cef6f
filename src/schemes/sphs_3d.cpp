#include "src/schemes/instantiate.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

Instantiations sphs_3d() {
  return instantiate<Sphs, 3>("sphs", "entropy", List<Hoct<4>, WendlandC2, BSpline<5>, Liq>{}, Masses::equal);
}

}  // namespace sphk
