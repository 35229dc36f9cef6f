#include "src/schemes/instantiate.hpp"
#include "src/schemes/osph.hpp"

namespace sphk {

Instantiations osph_1d() {
  return instantiate<OsphEntropy, 1>("osph", "entropy", List<>{});
}

}  // namespace sphk
