#pragma once

#include "kernels/passes/state.hpp"
#include "kernels/terms/error_terms.hpp"

namespace sphk {

/// What the sums for the errors of a scheme read of its particles, in columns of their own: Density is that of the
/// equations of motion, velocities are left at zero. All schemes share these sums.
template <int D>
using ErrorLayout =
    Layout<D, List<Position, Velocity, Mass, Support, InverseSupport, Density, InversePhi, InverseEta, Entropy>, void>;
using ErrorTermSet = TermSet<ErrorTerms, NeighbourhoodTerms>;
template <int D>
using ErrorColumns = Columns<D, typename ErrorTermSet::Adds>;

/// E0, R, V, the largest ratio of entropies and the nearest neighbour of every particle, in double. Defined in
/// error_loops.hpp, compiled for the kernels of the schemes in src/schemes/core_errors.cpp.
template <int D, class K>
ErrorColumns<D> error_sums(const Particles<ErrorLayout<D>>& particles, const Smoothing<K, D>& smoothing);

}  // namespace sphk
