#include "src/schemes/classic.hpp"
#include "src/schemes/instantiate.hpp"

namespace sphk {

Instantiations tsph_entropy_2d() {
  return instantiate<TsphEntropy, 2>("tsph", "entropy", List<>{});
}

}  // namespace sphk
