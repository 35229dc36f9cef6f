#include "src/schemes/instantiate.hpp"
#include "src/schemes/osph.hpp"

namespace sphk {

Instantiations osph_3d() {
  return instantiate<OsphEntropy, 3>("osph", "entropy", List<Hoct<4>>{});
}

}  // namespace sphk
