#include "src/schemes/instantiate.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

Instantiations sphs_energy_3d() {
  return instantiate<SphsEnergy, 3>("sphs", "energy", List<Hoct<4>>{}, Masses::equal);
}

}  // namespace sphk
