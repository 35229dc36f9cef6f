#include "src/schemes/classic.hpp"
#include "src/schemes/instantiate.hpp"

namespace sphk {

Instantiations gadget2_3d() {
  return instantiate<Gadget2, 3>("gadget2", "entropy", List<CubicSpline, WendlandC6>{});
}

}  // namespace sphk
