#include "src/schemes/instantiate.hpp"
#include "src/schemes/osph.hpp"

namespace sphk {

namespace {

template <template <int, class, class> class S>
void append_all(Instantiations& rows, const std::string& energy) {
  for (const Instantiations& some :
       {instantiate<S, 3>("osph-coherent", energy, List<>{}), instantiate<S, 2>("osph-coherent", energy, List<>{}),
        instantiate<S, 1>("osph-coherent", energy, List<>{})})
    rows.insert(rows.end(), some.begin(), some.end());
}

}  // namespace

Instantiations osph_coherent() {
  Instantiations rows;
  append_all<OsphCoherentEntropy>(rows, "entropy");
  append_all<OsphCoherentEnergy>(rows, "energy");
  return rows;
}

}  // namespace sphk
