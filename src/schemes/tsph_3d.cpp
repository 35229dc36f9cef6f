#include "src/schemes/instantiate.hpp"
#include "src/schemes/tsph.hpp"

namespace sphk {

Instantiations tsph_3d() {
  return instantiate<Tsph, 3>("tsph", "entropy", List<CoreTriangle, Hoct<4>>{});
}

}  // namespace sphk
