#include "src/schemes/every_dimension.hpp"
#include "src/schemes/osph.hpp"

namespace sphk {

Instantiations osph_energy() {
  return in_every_dimension<OsphEnergy>("osph", "energy", List<Hoct<4>>{});
}

}  // namespace sphk
