#include "src/schemes/instantiate.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

Instantiations sphs_energy_multi_3d() {
  return instantiate<SphsEnergyMulti, 3>("sphs", "energy", List<Hoct<4>>{});
}

}  // namespace sphk
