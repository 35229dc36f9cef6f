#include "src/schemes/classic.hpp"
#include "src/schemes/instantiate.hpp"

namespace sphk {

Instantiations tsph_energy_1d() {
  return instantiate<TsphEnergy, 1>("tsph", "energy", List<>{});
}

}  // namespace sphk
