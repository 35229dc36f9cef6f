#include "src/schemes/instantiate.hpp"
#include "src/schemes/tsph.hpp"

namespace sphk {

Instantiations tsph_2d() {
  return instantiate<Tsph, 2>("tsph", "entropy", List<>{});
}

}  // namespace sphk
