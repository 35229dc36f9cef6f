#include "src/schemes/classic.hpp"
#include "src/schemes/instantiate.hpp"

namespace sphk {

Instantiations sph_energy_2d() {
  return instantiate<SphEnergy, 2>("sph", "energy", List<>{});
}

}  // namespace sphk
