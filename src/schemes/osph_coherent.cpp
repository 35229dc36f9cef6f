#include "src/schemes/every_dimension.hpp"
#include "src/schemes/osph.hpp"

namespace sphk {

Instantiations osph_coherent() {
  return joined({in_every_dimension<OsphCoherentEntropy>("osph-coherent", "entropy", List<>{}),
                 in_every_dimension<OsphCoherentEnergy>("osph-coherent", "energy", List<>{})});
}

}  // namespace sphk
