#include "src/schemes/instantiate.hpp"
#include "src/schemes/sph.hpp"

namespace sphk {

Instantiations sph_entropy_1d() {
  return instantiate<SphEntropy, 1>("sph", "entropy", List<>{});
}

}  // namespace sphk
