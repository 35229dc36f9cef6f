#include "src/schemes/classic.hpp"
#include "src/schemes/instantiate.hpp"

namespace sphk {

Instantiations sph_entropy_2d() {
  return instantiate<SphEntropy, 2>("sph", "entropy", List<CubicSpline>{});
}

}  // namespace sphk
