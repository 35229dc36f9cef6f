#include "src/schemes/instantiate.hpp"
#include "src/schemes/sphs.hpp"

namespace sphk {

Instantiations sphs_energy_1d() {
  return instantiate<SphsEnergy, 1>("sphs", "energy", List<>{}, Masses::equal);
}

}  // namespace sphk
