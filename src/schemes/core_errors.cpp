#include <tuple>

#include "kernels/smoothing/list.hpp"
#include "kernels/smoothing/tabulated.hpp"
#include "src/engine/error_loops.hpp"

namespace sphk {

template <int D, class... K>
constexpr auto error_loops(List<K...>) {
  return std::tuple{&error_sums<D, K>..., &error_sums<D, Tabulated>};
}

[[gnu::used]] static const auto line = error_loops<1>(List<CubicSpline>{});
[[gnu::used]] static const auto plane = error_loops<2>(List<CubicSpline, Liq, Hoct<4>, WendlandC6>{});
[[gnu::used]] static const auto space =
    error_loops<3>(List<CubicSpline, CoreTriangle, Hoct<4>, Liq, BSpline<5>, WendlandC2, WendlandC6>{});

}  // namespace sphk
