// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/scheme_interface.hpp"

namespace sphk::detail {

/// Sums and extremes over particles, as a reduction.
struct TotalsSum {
  double mass = 0, kinetic = 0, thermal = 0, potential = 0;
  double p[3] = {0, 0, 0}, L[3] = {0, 0, 0};
  double p_sizes = 0, L_sizes = 0;
  double max_speed2 = 0;
  double lowest[3] = {1e300, 1e300, 1e300};  ///< of rho, P, A
  double highest[3] = {0, 0, 0};

  KOKKOS_INLINE_FUNCTION TotalsSum& operator+=(const TotalsSum& b) {
    mass += b.mass;
    kinetic += b.kinetic;
    thermal += b.thermal;
    potential += b.potential;
    p_sizes += b.p_sizes;
    L_sizes += b.L_sizes;
    max_speed2 = max(max_speed2, b.max_speed2);
    for (int k = 0; k < 3; ++k) {
      p[k] += b.p[k];
      L[k] += b.L[k];
      lowest[k] = min(lowest[k], b.lowest[k]);
      highest[k] = max(highest[k], b.highest[k]);
    }
    return *this;
  }
};

template <class L>
struct SumTotals {
  Particles<L> state;
  KOKKOS_INLINE_FUNCTION void operator()(int i, TotalsSum& sum) const {
    constexpr int D = L::dimension;
    const double gamma = state.parameters.gamma, m = state.template at<Mass>(i), rho = state.state_density(i);
    const double late = state.clock.late_of(i / cell_size), moved = late * state.clock.mobility;
    const double P =
        L::ThermalForm::pressure(state.template at<Thermal>(i) + late * state.template at<Heating>(i), rho, gamma);
    double x[3] = {0, 0, 0}, v[3] = {0, 0, 0};
    for (int d = 0; d < D; ++d) {
      x[d] = state.template at<Position>(i, d);
      v[d] = state.template at<Velocity>(i, d) + moved * state.template at<Acceleration>(i, d);
    }
    const double v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    TotalsSum one;
    one.mass = m;
    one.kinetic = 0.5 * m * v2;
    one.thermal = m * P / ((gamma - 1) * rho);
    one.potential = m * state.central.potential(state.position(i));
    one.max_speed2 = v2;
    for (int k = 0; k < 3; ++k) {
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      one.p[k] = m * v[k];
      one.L[k] = m * (x[a] * v[b] - x[b] * v[a]);
    }
    one.p_sizes = m * Kokkos::sqrt(v2);
    one.L_sizes = Kokkos::sqrt(one.L[0] * one.L[0] + one.L[1] * one.L[1] + one.L[2] * one.L[2]);
    const double values[3] = {rho, P, P / Kokkos::pow(rho, gamma)};
    for (int k = 0; k < 3; ++k) one.lowest[k] = one.highest[k] = values[k];
    sum += one;
  }
};

}  // namespace sphk::detail

template <>
struct Kokkos::reduction_identity<sphk::detail::TotalsSum> {
  KOKKOS_FORCEINLINE_FUNCTION static sphk::detail::TotalsSum sum() { return {}; }
};

namespace sphk {

/// Conserved sums and extremes. Positions are those of the run: in a periodic box angular momentum is about its origin
/// and jumps when a particle is wrapped.
template <class L>
Totals totals(const Particles<L>& state) {
  detail::TotalsSum sum;
  if (state.n > 0)
    Kokkos::parallel_reduce("totals", Kokkos::RangePolicy<ExecutionSpace>(0, state.n), detail::SumTotals<L>{state},
                            Kokkos::Sum<detail::TotalsSum>(sum));
  Totals totals;
  totals.mass = sum.mass;
  totals.kinetic = sum.kinetic;
  totals.thermal = sum.thermal;
  totals.potential = sum.potential;
  totals.max_speed = std::sqrt(sum.max_speed2);
  for (int k = 0; k < 3; ++k) totals.momentum[k] = sum.p[k], totals.angular_momentum[k] = sum.L[k];
  totals.momentum_sizes = sum.p_sizes;
  totals.angular_momentum_sizes = sum.L_sizes;
  totals.min_density = sum.lowest[0], totals.max_density = sum.highest[0];
  totals.min_pressure = sum.lowest[1], totals.max_pressure = sum.highest[1];
  totals.min_entropy = sum.lowest[2], totals.max_entropy = sum.highest[2];
  return totals;
}

}  // namespace sphk
