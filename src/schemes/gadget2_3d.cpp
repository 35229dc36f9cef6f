#include "src/schemes/gadget2.hpp"
#include "src/schemes/instantiate.hpp"

namespace sphk {

Instantiations gadget2_3d() {
  return instantiate<Gadget2, 3>("gadget2", "entropy", List<CubicSpline, WendlandC6>{});
}

}  // namespace sphk
