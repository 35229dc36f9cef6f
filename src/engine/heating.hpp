// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/scheme_interface.hpp"

namespace sphk {

namespace detail {

template <class L>
struct NearestTo {
  using Nearest = Kokkos::MinLoc<double, int>::value_type;
  Particles<L> state;
  double place[3];
  KOKKOS_INLINE_FUNCTION void operator()(int i, Nearest& nearest) const {
    double r2 = 0;
    for (int d = 0; d < L::dimension; ++d) {
      double x = state.template at<Position>(i, d) - place[d];
      const double period = state.tree.domain.period[d];
      if (period > 0) x -= period * Kokkos::round(x / period);
      r2 += x * x;
    }
    if (r2 < nearest.val || (r2 == nearest.val && i < nearest.loc)) nearest.val = r2, nearest.loc = i;
  }
};

/// Specific energies at the density of a row of the columns.
template <class L>
struct TakeEnergies {
  Particles<L> state;
  int density_row;
  Kokkos::View<double*, MemorySpace> u;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    const double gamma = state.parameters.gamma,
                 rho = state.columns.data(static_cast<std::size_t>(density_row) * state.columns.stride + i);
    u(i) = L::ThermalForm::pressure(state.template at<Thermal>(i), rho, gamma) / ((gamma - 1) * rho);
  }
};

/// Scales thermal variables by what their energies lack; the largest such share.
template <class L>
struct ApproachEnergies {
  Particles<L> state;
  Kokkos::View<double*, MemorySpace> u;
  KOKKOS_INLINE_FUNCTION void operator()(int i, double& worst) const {
    const double gamma = state.parameters.gamma, rho = state.state_density(i);
    double& s = state.template at<Thermal>(i);
    const double now = L::ThermalForm::pressure(s, rho, gamma) / ((gamma - 1) * rho);
    if (now == u(i)) return;
    worst = max(worst, now > 0 ? abs(u(i) / now - 1) : 1);
    s = now > 0 ? s * (u(i) / now) : L::ThermalForm::from_energy(u(i), rho, gamma);
  }
};

template <class L>
struct AddHeat {
  Particles<L> state;
  Kokkos::View<double*, MemorySpace> u;
  double energy;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const { u(i) += energy / state.template at<Mass>(i); }
};

template <class L>
Kokkos::RangePolicy<ExecutionSpace> all_of(const Particles<L>& state) {
  return {0, state.n};
}

}  // namespace detail

using Energies = Kokkos::View<double*, MemorySpace>;

/// The specific energies that particles have at the density in a row of the columns. They hold until the next step.
template <class L>
Energies energies_at(const Run<L>& run, int density_row) {
  const Particles<L>& state = run.state;
  const Energies u = idle_row(run);
  Kokkos::parallel_for("energies", detail::all_of(state), detail::TakeEnergies<L>{state, density_row, u});
  return u;
}

/// Adds energy to that of the particle nearest to a place.
template <class L>
void heat_nearest(const Particles<L>& state, const Energies& u, const Array3& place, double energy) {
  if (state.n == 0) return;
  typename detail::NearestTo<L>::Nearest nearest;
  Kokkos::parallel_reduce("nearest particle", detail::all_of(state),
                          detail::NearestTo<L>{state, {place[0], place[1], place[2]}},
                          Kokkos::MinLoc<double, int>(nearest));
  Kokkos::parallel_for("add heat", Kokkos::RangePolicy<ExecutionSpace>(nearest.loc, nearest.loc + 1),
                       detail::AddHeat<L>{state, u, energy});
}

/// Gives the particles specific energies u at the density of the equations of motion, which `find_density` computes. A
/// generalised density hangs on the entropies: with P_i = (sum_j m_j A_j^(1/gamma) W)^gamma the energies lack a share
/// that each round makes smaller by at least (gamma-1)/gamma. It ends where the pair arithmetic sees no difference.
template <class L>
void take_energies(const Particles<L>& state, const Energies& u, const std::function<void()>& find_density) {
  double before = 1e300;
  for (int round = 0; round < 100; ++round) {
    find_density();
    double worst = 0;
    Kokkos::parallel_reduce("approach energies", detail::all_of(state), detail::ApproachEnergies<L>{state, u},
                            Kokkos::Max<double>(worst));
    if (worst < 1e-12 || (round > 4 && worst < 1e-5 && worst > 0.7 * before)) return;
    before = worst;
  }
}

}  // namespace sphk
