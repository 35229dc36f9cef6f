#include <tuple>

#include "kernels/passes/rates.hpp"
#include "kernels/smoothing/list.hpp"
#include "kernels/smoothing/tabulated.hpp"
#include "src/engine/error_sums.hpp"

namespace sphk {

namespace {

template <int D, class K>
struct ErrorScheme {
  static constexpr int dimension = D;
  using Layout = ErrorLayout<D>;
  using Kernel = K;
  using PairNumber = double;
};

template <int D, class... K>
constexpr auto error_loops(List<K...>) {
  return std::tuple{&error_sums<D, K>..., &error_sums<D, Tabulated>};
}

}  // namespace

template <int D, class K>
ErrorColumns<D> error_sums(const Particles<ErrorLayout<D>>& particles, const Smoothing<K, D>& smoothing) {
  ErrorColumns<D> out("error sums", particles.n);
  const State<ErrorScheme<D, K>> state{particles, smoothing};
  add_pair_sums("errors", state, ErrorTermSet(particles.parameters), out);
  return out;
}

[[gnu::used]] static const auto line = error_loops<1>(List<CubicSpline>{});
[[gnu::used]] static const auto plane = error_loops<2>(List<CubicSpline, Liq, Hoct<4>, WendlandC6>{});
[[gnu::used]] static const auto space = error_loops<3>(List<CubicSpline, CoreTriangle, Hoct<4>, WendlandC6>{});

}  // namespace sphk
