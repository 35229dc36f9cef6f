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

template <class L>
struct AddHeat {
  Particles<L> state;
  double energy;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    const double gamma = state.parameters.gamma, rho = state.state_density(i);
    double& s = state.template at<Thermal>(i);
    const double u = L::ThermalForm::pressure(s, rho, gamma) / ((gamma - 1) * rho);
    s = L::ThermalForm::from_energy(u + energy / state.template at<Mass>(i), rho, gamma);
  }
};

}  // namespace detail

/// Adds energy to the particle nearest to a place.
template <class L>
void heat_nearest(const Particles<L>& state, const Array3& place, double energy) {
  if (state.n == 0) return;
  typename detail::NearestTo<L>::Nearest nearest;
  Kokkos::parallel_reduce("nearest particle", Kokkos::RangePolicy<ExecutionSpace>(0, state.n),
                          detail::NearestTo<L>{state, {place[0], place[1], place[2]}},
                          Kokkos::MinLoc<double, int>(nearest));
  Kokkos::parallel_for("add heat", Kokkos::RangePolicy<ExecutionSpace>(nearest.loc, nearest.loc + 1),
                       detail::AddHeat<L>{state, energy});
}

}  // namespace sphk
