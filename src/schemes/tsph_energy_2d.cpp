#include "src/schemes/classic.hpp"
#include "src/schemes/instantiate.hpp"

namespace sphk {

Instantiations tsph_energy_2d() {
  return instantiate<TsphEnergy, 2>("tsph", "energy", List<>{});
}

}  // namespace sphk
