#include "src/schemes/instantiate.hpp"
#include "src/schemes/osph.hpp"

namespace sphk {

Instantiations osph_energy() {
  Instantiations rows = instantiate<OsphEnergy, 3>("osph", "energy", List<Hoct<4>>{});
  for (Instantiation& row : instantiate<OsphEnergy, 2>("osph", "energy", List<>{})) rows.push_back(row);
  for (Instantiation& row : instantiate<OsphEnergy, 1>("osph", "energy", List<>{})) rows.push_back(row);
  return rows;
}

}  // namespace sphk
