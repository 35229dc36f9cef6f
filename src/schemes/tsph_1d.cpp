#include "src/schemes/instantiate.hpp"
#include "src/schemes/tsph.hpp"

namespace sphk {

Instantiations tsph_1d() {
  return instantiate<Tsph, 1>("tsph", "entropy", List<>{});
}

}  // namespace sphk
