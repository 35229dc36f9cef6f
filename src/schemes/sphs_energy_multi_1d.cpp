#include "src/schemes/instantiate.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

Instantiations sphs_energy_multi_1d() {
  return instantiate<SphsEnergyMulti, 1>("sphs", "energy", List<>{});
}

}  // namespace sphk
