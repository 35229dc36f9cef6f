// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernels/core/polynomial.hpp"
#include "src/engine/scheme_interface.hpp"

namespace sphk {

/// Bytes of device memory per particle: the columns, ids, cells.
template <class L>
inline constexpr double bytes_per_particle = sizeof(double) * Particles<L>::Columns::size + sizeof(std::uint64_t) +
                                             sizeof(Bounds<L::dimension>) * (1.0 / 7);

/// What steps of the particles' own take beside it: begins, ends, powers and the memory of sorts; ranges of the nodes,
/// four subsets, how late cells are.
inline constexpr double bytes_of_own_steps = 2 * sizeof(Ticks) + 1 + RadixSort::rows * sizeof(double) +
                                             sizeof(StepRange) * (1.0 / 7) + (4 * 12.0 + 8) / cell_size;

/// Flops of one pair inside the support, loop by loop: distance, smoothing kernels, terms.
inline constexpr int flops_of_distance(int dimension) {
  return 3 * dimension + 1;
}
template <class S>
inline constexpr double flops_of_search = flops_of_distance(S::dimension) + 2 + S::Kernel::flops + 7;
template <class S>
inline constexpr double flops_of_density_terms =
    S::DensityTerms::List::size == 0 ? 0 : S::Kernel::flops + S::dimension + 5 + S::DensityTerms::flops;
/// The weight, the basis, one product and addition a moment and two products and an addition a right-hand side.
template <class S>
inline constexpr double flops_of_fit = flops_of_distance(S::dimension) + 2 * S::Kernel::flops + 8 + S::dimension +
                                       3 * Monomials<S::dimension>::basis + 2 * Monomials<S::dimension>::count
                                       + S::dimension*(2 * Monomials<S::dimension>::basis + 2);
/// Distance, both kernels, one product and sum.
template <class S>
inline constexpr double flops_of_general_density = flops_of_distance(S::dimension) +
                                                   2 * (S::Kernel::flops + S::dimension + 1) + 5;
template <class S>
inline constexpr double flops_of_rates = flops_of_distance(S::dimension) +
                                         2 * (S::Kernel::flops + S::dimension + 3) + S::RateTerms::flops + 4;

/// Flops of one pair in a step.
template <class S>
constexpr double flops_per_pair() {
  constexpr bool fits = contains<GradVelocityDivergence, typename S::Fields>,
                 generalised = contains<GeneralDensity, typename S::Fields>;
  return flops_of_search<S> + flops_of_density_terms<S> + (fits ? flops_of_fit<S> : 0) +
         (generalised ? flops_of_general_density<S> : 0) + flops_of_rates<S>;
}

Counts counts_of(const StepCounts& steps);

}  // namespace sphk
