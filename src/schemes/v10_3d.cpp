#include "src/schemes/instantiate.hpp"
#include "src/schemes/v10.hpp"

namespace sphk {

Instantiations v10_3d() {
  Instantiations rows = instantiate<V10, 3>("v10", "entropy", List<>{});
  for (const Instantiations& some : {instantiate<V10Plain, 3>("v10-plain", "entropy", List<>{}),
                                     instantiate<V10Smoothed, 3>("v10-smoothed", "entropy", List<>{}),
                                     instantiate<V10Relaxation, 3>("relaxation", "energy", List<>{})})
    rows.insert(rows.end(), some.begin(), some.end());
  return rows;
}

}  // namespace sphk
