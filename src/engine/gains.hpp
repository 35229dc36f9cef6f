// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/errors.hpp"
#include "src/engine/heating.hpp"

namespace sphk {

namespace detail {

using Numbers1 = Kokkos::View<const double*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged>;

struct AddEnergies {
  Kokkos::View<double*, MemorySpace> u;
  Kokkos::View<const double*, MemorySpace> gain;
  KOKKOS_INLINE_FUNCTION void operator()(int i, long& negative) const {
    u(i) += gain(i);
    negative += !(u(i) >= 0);
  }
};

template <class L>
struct AddVelocities {
  Particles<L> state;
  Kokkos::View<const double*, MemorySpace> gain;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    constexpr int D = L::dimension;
    for (int d = 0; d < D; ++d) state.template at<Velocity>(i, d) += gain(static_cast<std::size_t>(i) * D + d);
  }
};

/// On the device, `components` numbers a particle.
template <class L>
Kokkos::View<const double*, MemorySpace> gains_of(const Particles<L>& state, const std::vector<double>& numbers,
                                                  int components, const char* what) {
  if (numbers.size() != static_cast<std::size_t>(state.n) * static_cast<std::size_t>(components))
    throw InputError(fmt::format("gains of {}: {} numbers are given for {} particles in {}D; {} a particle are wanted",
                                 what, numbers.size(), state.n, L::dimension, components));
  return Kokkos::create_mirror_view_and_copy(MemorySpace{}, Numbers1(numbers.data(), numbers.size()));
}

}  // namespace detail

/// Adds gains to velocities, and to the specific energies u.
template <class L>
void add_gains(const Particles<L>& state, const Energies& u, const Gains& gains) {
  if (!gains.energy.empty()) {
    long negative = 0;
    const detail::AddEnergies body{u, detail::gains_of(state, gains.energy, 1, "energy")};
    Kokkos::parallel_reduce("add energies", detail::all_of(state), body, negative);
    if (negative > 0)
      throw NumericsError(
          fmt::format("gains of energy: {} of {} particles would be left with less than none; take less at once, in "
                      "shorter intervals, or as a share of what they have",
                      negative, state.n));
  }
  if (!gains.velocity.empty())
    Kokkos::parallel_for(
        "add velocities", detail::all_of(state),
        detail::AddVelocities<L>{state, detail::gains_of(state, gains.velocity, L::dimension, "velocity")});
}

}  // namespace sphk
