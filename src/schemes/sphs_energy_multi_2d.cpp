#include "src/schemes/instantiate.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

Instantiations sphs_energy_multi_2d() {
  return instantiate<SphsEnergyMulti, 2>("sphs", "energy", List<Hoct<4>, WendlandC6>{});
}

}  // namespace sphk
