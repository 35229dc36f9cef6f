#pragma once

#include "src/schemes/instantiate.hpp"

namespace sphk {

/// One list of several.
inline Instantiations joined(std::initializer_list<Instantiations> lists) {
  Instantiations rows;
  for (const Instantiations& list : lists) rows.insert(rows.end(), list.begin(), list.end());
  return rows;
}

/// Rows for scheme S in 1D, 2D and 3D, in one source file: for schemes with few kernels in closed form, in 3D alone.
template <template <int, class, class> class S, class... K>
Instantiations in_every_dimension(const std::string& scheme, const std::string& energy, List<K...> curated_in_3d) {
  return joined({instantiate<S, 3>(scheme, energy, curated_in_3d), instantiate<S, 2>(scheme, energy, List<>{}),
                 instantiate<S, 1>(scheme, energy, List<>{})});
}

}  // namespace sphk
