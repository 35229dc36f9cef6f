// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "src/engine/particle_set.hpp"

namespace sphk {

/// Mean, 95th percentile and largest |E0| of a set of particles.
struct ErrorShare {
  std::size_t particles = 0;
  double mean = 0, high = 0, max = 0;
};

/// How well the particles sample their kernels: |E0| (R10 eq 28) of all of them, of those where fluids meet and of the
/// others; mean |R - 1| and |V - 1| (Frobenius norm; R10 eq 29); mean |epsilon| (R10 eq 21) over mean |rho div v|;
/// distances of nearest neighbours in mean spacings (m/rho)^(1/D), whose low end tells particles that clump.
struct ErrorBudget {
  ErrorShare all, boundary, bulk;
  double R = 0, V = 0, epsilon = 0;
  double nearest = 0, nearest_low = 0;  ///< mean and 5th percentile
};

/// A particle is at a boundary where a neighbour's entropy function differs by more than this factor.
inline constexpr double boundary_contrast = 1.25;

/// `errors` are those of Simulation::errors at the time of the snapshot.
ErrorBudget error_budget(const Snapshot& snapshot, const std::vector<Field>& errors);

/// Columns of history.csv; those of sets without particles are nan.
std::vector<std::pair<std::string, double>> columns(const ErrorBudget& budget);

}  // namespace sphk
