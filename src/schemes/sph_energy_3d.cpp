#include "src/schemes/instantiate.hpp"
#include "src/schemes/sph.hpp"

namespace sphk {

Instantiations sph_energy_3d() {
  return instantiate<SphEnergy, 3>("sph", "energy", List<>{});
}

}  // namespace sphk
