#include "src/schemes/instantiate.hpp"
#include "src/schemes/sph.hpp"

namespace sphk {

Instantiations sph_entropy_3d() {
  return instantiate<SphEntropy, 3>("sph", "entropy", List<CubicSpline, Hoct<4>>{});
}

}  // namespace sphk
