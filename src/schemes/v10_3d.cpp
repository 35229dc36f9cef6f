#include "src/schemes/every_dimension.hpp"
#include "src/schemes/v10.hpp"

namespace sphk {

Instantiations v10_3d() {
  return joined({instantiate<V10, 3>("v10", "entropy", List<>{}),
                 instantiate<V10Plain, 3>("v10-plain", "entropy", List<>{}),
                 instantiate<V10Smoothed, 3>("v10-smoothed", "entropy", List<>{}),
                 instantiate<V10Relaxation, 3>("relaxation", "energy", List<>{})});
}

}  // namespace sphk
