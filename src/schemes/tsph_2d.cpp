#include "src/schemes/classic.hpp"
#include "src/schemes/instantiate.hpp"

namespace sphk {

Instantiations tsph_2d() {
  return instantiate<Tsph, 2>("tsph", "entropy", List<>{});
}

}  // namespace sphk
