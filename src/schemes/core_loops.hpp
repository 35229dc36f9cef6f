#pragma once

#include <tuple>

#include "kernels/passes/gradients.hpp"
#include "kernels/passes/smoothing_length.hpp"
#include "kernels/smoothing/list.hpp"
#include "kernels/smoothing/tabulated.hpp"

namespace sphk {

// The loops for density and gradients are compiled apart from the schemes that share them: a change of a term leaves
// them alone. A scheme with core fields or a kernel that no core_*.cpp lists does not link.

/// A scheme's core in D dimensions: Core of the CoreFields, the sums of the density loop beside n and rho.
template <int D, class Core, class K, class T, class DensitySums>
using CoreOf = CoreScheme<Layout<D, Union<BaseFields, Core>, void>, K, T, DensitySums>;

/// Density loops, mixed and double, with the kernels of a list and with the table.
template <int D, class Core, class DensitySums, class... K>
constexpr auto density_loops(List<K...>) {
  return std::tuple{&find_support<CoreOf<D, Core, K, float, DensitySums>>...,
                    &find_support<CoreOf<D, Core, K, double, DensitySums>>...,
                    &find_support<CoreOf<D, Core, Tabulated, float, DensitySums>>,
                    &find_support<CoreOf<D, Core, Tabulated, double, DensitySums>>};
}

/// The same of the fits of velocity gradients, for schemes without further sums in the density loop.
template <int D, class Core, class... K>
constexpr auto gradient_loops(List<K...>) {
  using None = TermSet<>;
  return std::tuple{&fit_velocities<CoreOf<D, Core, K, float, None>>...,
                    &fit_velocities<CoreOf<D, Core, K, double, None>>...,
                    &fit_velocities<CoreOf<D, Core, Tabulated, float, None>>,
                    &fit_velocities<CoreOf<D, Core, Tabulated, double, None>>};
}

/// Core fields of the schemes, in the order of CoreFields.
using ClassicCore = List<VelocityDivergence, VelocityCurl>;
using Gadget2Core = List<VelocityDivergence, VelocityCurl, DensitySlope>;
using SphsCore = List<VelocityDivergence, VelocityCurl, GradVelocityDivergence>;
using SphsConservativeCore = List<VelocityDivergence, VelocityCurl, DensitySlope, GradVelocityDivergence>;

}  // namespace sphk
