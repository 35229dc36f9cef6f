#include "src/schemes/instantiate.hpp"
#include "src/schemes/osph.hpp"

namespace sphk {

Instantiations osph_2d() {
  return instantiate<OsphEntropy, 2>("osph", "entropy", List<>{});
}

}  // namespace sphk
