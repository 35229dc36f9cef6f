#include "src/schemes/every_dimension.hpp"
#include "src/schemes/tsph.hpp"

namespace sphk {

Instantiations tsph_energy() {
  return in_every_dimension<TsphEnergy>("tsph", "energy", List<Hoct<4>>{});
}

}  // namespace sphk
