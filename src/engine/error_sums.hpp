// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/state.hpp"
#include "kernels/smoothing/any.hpp"
#include "kernels/terms/error_terms.hpp"
#include "src/engine/particle_set.hpp"

namespace sphk {

/// What the sums for the errors of a scheme read of its particles, in columns of their own: Density is that of the
/// equations of motion, velocities are left at zero. All schemes share these sums.
template <int D>
using ErrorLayout =
    Layout<D,
           List<Position, Velocity, Mass, Support, InverseSupport, Density, InversePhi, InverseEta, EtaRate, Entropy>,
           void>;
using ErrorTermSet = TermSet<ErrorTerms, NeighbourhoodTerms>;

/// Columns of those fields, allocated.
template <int D>
Columns<D, typename ErrorLayout<D>::Fields> error_columns(int n);
extern template Columns<1, ErrorLayout<1>::Fields> error_columns<1>(int n);
extern template Columns<2, ErrorLayout<2>::Fields> error_columns<2>(int n);
extern template Columns<3, ErrorLayout<3>::Fields> error_columns<3>(int n);

/// E0, R, V and epsilon of every particle (R10 eq 21, 28-30), how unlike its neighbours' entropies are and how near the
/// nearest is, by id. Cells and supports are those of the last step. Defined in error_loops.hpp.
template <int D, class K>
std::vector<Field> error_fields(const Particles<ErrorLayout<D>>& particles, const Smoothing<K, D>& smoothing);

extern template std::vector<Field> error_fields(const Particles<ErrorLayout<1>>&, const Smoothing<AnyKernel, 1>&);
extern template std::vector<Field> error_fields(const Particles<ErrorLayout<2>>&, const Smoothing<AnyKernel, 2>&);
extern template std::vector<Field> error_fields(const Particles<ErrorLayout<3>>&, const Smoothing<AnyKernel, 3>&);

}  // namespace sphk
