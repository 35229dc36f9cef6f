#include "src/schemes/classic.hpp"
#include "src/schemes/instantiate.hpp"

namespace sphk {

Instantiations tsph_energy_3d() {
  return instantiate<TsphEnergy, 3>("tsph", "energy", List<>{});
}

}  // namespace sphk
