// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/gradients.hpp"
#include "kernels/passes/smoothing_length.hpp"
#include "kernels/smoothing/list.hpp"
#include "kernels/smoothing/tabulated.hpp"
#include "kernels/terms/velocity_gradient.hpp"

namespace sphk {

// Loops over pairs that many schemes share are compiled once, apart from them (loops.hpp): a change of a term then
// leaves them alone. What is listed here is; loops of other kernels, fields or sums are compiled with the scheme that
// has them, which takes longer to build and is otherwise the same.

/// Lists for 1D, 2D and 3D.
template <class Line, class Plane, class Space>
struct ByDimension {
  template <int D>
  using in = std::conditional_t<D == 1, Line, std::conditional_t<D == 2, Plane, Space>>;
};

/// Fields of the core beside the BaseFields, sums of the density loop, smoothing kernels beside the table.
template <class CoreFieldList, class DensitySums, class Kernels>
struct SharedLoops {
  using Sums = DensitySums;
  template <int D>
  using Layout = sphk::Layout<D, Union<BaseFields, CoreFieldList>, void>;
  template <int D>
  using Kernel = Union<typename Kernels::template in<D>, List<Tabulated>>;
  static constexpr bool has_gradients = contains<GradVelocityDivergence, CoreFieldList>;
};

using DivergenceSum = TermSet<VelocityDivergenceSum>;
using GradientSums = TermSet<VelocityDivergenceSum, VelocityCurlSum>;

// Families of them, each a library for every dimension and pair arithmetic (CMakeLists.txt).

/// Without Balsara's factor; SPHS without a switch.
using PlainLoops = List<SharedLoops<List<VelocityDivergence>, DivergenceSum,
                                    ByDimension<List<>, List<CubicSpline>, List<CubicSpline, Hoct<4>>>>>;
/// sph, tsph, osph.
using ClassicLoops =
    List<SharedLoops<List<VelocityDivergence, VelocityCurl>, GradientSums,
                     ByDimension<List<>, List<CubicSpline>, List<CubicSpline, CoreTriangle, Hoct<4>>>>>;
/// gadget2, v10: with Balsara's factor and without.
using GradHLoops = List<SharedLoops<List<VelocityDivergence, VelocityCurl, DensitySlope>, GradientSums,
                                    ByDimension<List<>, List<CubicSpline, Liq>, List<CubicSpline, WendlandC6>>>,
                        SharedLoops<List<VelocityDivergence, DensitySlope>, DivergenceSum,
                                    ByDimension<List<>, List<CubicSpline>, List<CubicSpline>>>>;
/// sphs; sphs-conservative.
using FittedLoops =
    List<SharedLoops<List<VelocityDivergence, VelocityCurl, GradVelocityDivergence>, TermSet<>,
                     ByDimension<List<>, List<Hoct<4>, WendlandC6>, List<Hoct<4>, WendlandC2, BSpline<5>, Liq>>>,
         SharedLoops<List<VelocityDivergence, VelocityCurl, DensitySlope, GradVelocityDivergence>, TermSet<>,
                     ByDimension<List<>, List<>, List<Hoct<4>>>>>;
using AllSharedLoops = Union<PlainLoops, ClassicLoops, GradHLoops, FittedLoops>;

namespace detail {
template <class L, class K, class DensitySums, class... Shared>
constexpr bool is_shared(List<Shared...>) {
  constexpr int D = L::dimension;
  return ((std::is_same_v<L, typename Shared::template Layout<D>> &&
           std::is_same_v<DensitySums, typename Shared::Sums> && contains<K, typename Shared::template Kernel<D>>) ||
          ...);
}
}  // namespace detail

template <class L, class K, class T, class DensitySums>
inline constexpr bool compiled_apart<CoreScheme<L, K, T, DensitySums>> =
    detail::is_shared<L, K, DensitySums>(AllSharedLoops{});

}  // namespace sphk
