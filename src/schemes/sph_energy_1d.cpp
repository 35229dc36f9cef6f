#include "src/schemes/instantiate.hpp"
#include "src/schemes/sph.hpp"

namespace sphk {

Instantiations sph_energy_1d() {
  return instantiate<SphEnergy, 1>("sph", "energy", List<>{});
}

}  // namespace sphk
