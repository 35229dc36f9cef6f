#include "src/schemes/classic.hpp"
#include "src/schemes/instantiate.hpp"

namespace sphk {

Instantiations tsph_1d() {
  return instantiate<Tsph, 1>("tsph", "entropy", List<>{});
}

}  // namespace sphk
