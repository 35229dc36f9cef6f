#include "src/schemes/instantiate.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

Instantiations sphs_energy_2d() {
  return instantiate<SphsEnergy, 2>("sphs", "energy", List<Hoct<4>, WendlandC6>{}, Masses::equal);
}

}  // namespace sphk
