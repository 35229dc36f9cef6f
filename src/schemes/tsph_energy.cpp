#include "src/schemes/instantiate.hpp"
#include "src/schemes/tsph.hpp"

namespace sphk {

Instantiations tsph_energy() {
  Instantiations rows = instantiate<TsphEnergy, 3>("tsph", "energy", List<Hoct<4>>{});
  for (Instantiation& row : instantiate<TsphEnergy, 2>("tsph", "energy", List<>{})) rows.push_back(row);
  for (Instantiation& row : instantiate<TsphEnergy, 1>("tsph", "energy", List<>{})) rows.push_back(row);
  return rows;
}

}  // namespace sphk
