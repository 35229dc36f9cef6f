#pragma once

#include <tuple>

#include "kernels/passes/gradients.hpp"
#include "kernels/passes/smoothing_length.hpp"
#include "kernels/smoothing/list.hpp"
#include "kernels/smoothing/tabulated.hpp"

namespace sphk {

// The loops for density and gradients are compiled apart from the schemes that share them: a change of a term leaves
// them alone. A scheme with a kernel that is not listed in its core_*.cpp does not link.

/// The density loops of scheme S in D dimensions, mixed and double, with the kernels of a list and with the table.
template <template <int, class, class> class S, int D, class... K>
constexpr auto density_loops(List<K...>) {
  return std::tuple{&find_support<typename S<D, K, float>::Core>..., &find_support<typename S<D, K, double>::Core>...,
                    &find_support<typename S<D, Tabulated, float>::Core>,
                    &find_support<typename S<D, Tabulated, double>::Core>};
}

/// The same of the fits of velocity gradients.
template <template <int, class, class> class S, int D, class... K>
constexpr auto gradient_loops(List<K...>) {
  return std::tuple{&fit_velocities<typename S<D, K, float>::Core>..., &fit_velocities<typename S<D, K, double>::Core>...,
                    &fit_velocities<typename S<D, Tabulated, float>::Core>,
                    &fit_velocities<typename S<D, Tabulated, double>::Core>};
}

}  // namespace sphk
