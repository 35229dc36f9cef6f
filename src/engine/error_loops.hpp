// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/rates.hpp"
#include "src/engine/error_sums.hpp"
#include "src/engine/host_columns.hpp"

namespace sphk {

namespace detail {

template <int D, class K>
struct ErrorScheme {
  static constexpr int dimension = D;
  using Layout = ErrorLayout<D>;
  using Kernel = K;
  using PairNumber = double;
};

/// The sums for errors as fields: two of them are written otherwise than they are summed up.
std::vector<Field> written_errors(const HostRows& rows, std::span<const FieldPlace> places);

}  // namespace detail

template <int D, class K>
std::vector<Field> error_fields(const Particles<ErrorLayout<D>>& particles, const Smoothing<K, D>& smoothing) {
  using Sums = typename ErrorTermSet::Adds;
  const Columns<D, Sums> out("error sums", particles.n);
  const State<detail::ErrorScheme<D, K>> state{particles, smoothing};
  add_pair_sums("errors", state, ErrorTermSet(Given{}), out);
  return detail::written_errors(HostRows(out.data, out.stride, particles.ids, D, particles.parameters.gamma),
                                field_places<D, Sums>);
}

}  // namespace sphk
