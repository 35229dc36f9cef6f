#include "src/schemes/instantiate.hpp"
#include "src/schemes/sph.hpp"

namespace sphk {

Instantiations sph_entropy_2d() {
  return instantiate<SphEntropy, 2>("sph", "entropy", List<CubicSpline>{});
}

}  // namespace sphk
