#include "src/schemes/classic.hpp"
#include "src/schemes/instantiate.hpp"

namespace sphk {

Instantiations tsph_entropy_1d() {
  return instantiate<TsphEntropy, 1>("tsph", "entropy", List<>{});
}

}  // namespace sphk
