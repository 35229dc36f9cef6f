#include "src/schemes/gadget2.hpp"
#include "src/schemes/instantiate.hpp"

namespace sphk {

Instantiations gadget2_1d() {
  return instantiate<Gadget2, 1>("gadget2", "entropy", List<>{});
}

}  // namespace sphk
