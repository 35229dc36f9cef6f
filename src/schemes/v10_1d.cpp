#include "src/schemes/every_dimension.hpp"
#include "src/schemes/v10.hpp"

namespace sphk {

Instantiations v10_1d() {
  return joined({instantiate<V10, 1>("v10", "entropy", List<>{}),
                 instantiate<V10Plain, 1>("v10-plain", "entropy", List<>{}),
                 instantiate<V10Smoothed, 1>("v10-smoothed", "entropy", List<>{}),
                 instantiate<V10Relaxation, 1>("relaxation", "energy", List<>{})});
}

}  // namespace sphk
