#include "src/schemes/instantiate.hpp"
#include "src/schemes/sph.hpp"

namespace sphk {

Instantiations sph_energy_2d() {
  return instantiate<SphEnergy, 2>("sph", "energy", List<>{});
}

}  // namespace sphk
