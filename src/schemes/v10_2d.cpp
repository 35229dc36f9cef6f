#include "src/schemes/instantiate.hpp"
#include "src/schemes/v10.hpp"

namespace sphk {

Instantiations v10_2d() {
  Instantiations rows = instantiate<V10, 2>("v10", "entropy", List<CubicSpline, Liq>{});
  for (const Instantiations& some : {instantiate<V10Plain, 2>("v10-plain", "entropy", List<>{}),
                                     instantiate<V10Smoothed, 2>("v10-smoothed", "entropy", List<>{}),
                                     instantiate<V10Relaxation, 2>("relaxation", "energy", List<>{})})
    rows.insert(rows.end(), some.begin(), some.end());
  return rows;
}

}  // namespace sphk
