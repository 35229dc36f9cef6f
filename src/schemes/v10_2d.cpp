#include "src/schemes/every_dimension.hpp"
#include "src/schemes/v10.hpp"

namespace sphk {

Instantiations v10_2d() {
  return joined({instantiate<V10, 2>("v10", "entropy", List<CubicSpline, Liq>{}),
                 instantiate<V10Plain, 2>("v10-plain", "entropy", List<>{}),
                 instantiate<V10Smoothed, 2>("v10-smoothed", "entropy", List<>{}),
                 instantiate<V10Relaxation, 2>("relaxation", "energy", List<>{})});
}

}  // namespace sphk
