#include "src/schemes/gadget2.hpp"
#include "src/schemes/instantiate.hpp"

namespace sphk {

Instantiations gadget2_2d() {
  return instantiate<Gadget2, 2>("gadget2", "entropy", List<CubicSpline>{});
}

}  // namespace sphk
