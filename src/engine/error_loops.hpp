#pragma once

#include "kernels/passes/rates.hpp"
#include "src/engine/error_sums.hpp"

namespace sphk {

namespace detail {
template <int D, class K>
struct ErrorScheme {
  static constexpr int dimension = D;
  using Layout = ErrorLayout<D>;
  using Kernel = K;
  using PairNumber = double;
};
}  // namespace detail

template <int D, class K>
ErrorColumns<D> error_sums(const Particles<ErrorLayout<D>>& particles, const Smoothing<K, D>& smoothing) {
  ErrorColumns<D> out("error sums", particles.n);
  const State<detail::ErrorScheme<D, K>> state{particles, smoothing};
  add_pair_sums("errors", state, ErrorTermSet(particles.parameters), out);
  return out;
}

}  // namespace sphk
