#include "src/schemes/classic.hpp"
#include "src/schemes/instantiate.hpp"

namespace sphk {

Instantiations sph_entropy_1d() {
  return instantiate<SphEntropy, 1>("sph", "entropy", List<>{});
}

}  // namespace sphk
