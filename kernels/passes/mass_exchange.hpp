// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/rates.hpp"
#include "kernels/passes/run.hpp"
#include "kernels/passes/state_equation.hpp"
#include "kernels/terms/mass_dissipation.hpp"

namespace sphk {

namespace detail {

/// Adds what exchanged mass does to v and u. With M = dm_i/dt and the sums p = sum G (v_j - v_i), e = sum G [u_j - u_i
/// + v_ij^2/2] of MassDissipation: donor:        m dv/dt = p,        m du/dt = e; flux:         m dv/dt = p + v M,  m
/// du/dt = e + v . p + (v^2/2 + u) M  (S12 eq E6, E8); per particle: m dv/dt = -v M,     m du/dt = (v^2/2 - u) M (S12
/// eq 39-40).
template <class L>
struct CorrectForMass {
  Particles<L> state;
  MassForm form;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    if (!state.active.contains(i)) return;
    constexpr int D = L::dimension;
    const auto s = state.columns.template load<List<MassRate, MassMomentum, MassEnergy, Velocity, Mass>>(i);
    const double m_inv = 1 / s.m;
    const double u =
        state.template at<Pressure>(i) * state.template at<InverseDensity>(i) / (state.parameters.gamma - 1);
    const double own = form.own;
    for (int d = 0; d < D; ++d) state.template at<Acceleration>(i, d) += m_inv * (s.dm_v[d] + own * s.dm * s.v[d]);
    const double flux = form.loss * dot(s.v, s.dm_v);  // loss is 1 for the flux form alone
    const double heat = s.dm_e + own * (own * 0.5 * dot(s.v, s.v) + u) * s.dm + flux;
    state.template at<Heating>(i) += m_inv * heat;
  }
};

/// du_i/dt -= (P_i/rho_i^2) sum_j (dm_j/dt) W(r_ij, h_i): the work of the change of rho that exchanged mass makes.
template <class L>
struct PayForDensity {
  Particles<L> state;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    if (!state.active.contains(i)) return;
    const double rho_inv = state.template at<InverseDensity>(i);
    state.template at<Heating>(i) -=
        state.template at<Pressure>(i) * rho_inv * rho_inv * state.template at<MassDensityRate>(i);
  }
};

template <class L>
struct AnyMassRate {
  Particles<L> state;
  KOKKOS_INLINE_FUNCTION void operator()(int i, int& any) const { any = any || state.template at<MassRate>(i) != 0; }
};

}  // namespace detail

/// What the exchange of mass does to velocities and energies, by the run's form of the corrections (S12 sec 4.3.3,
/// App. E). Nothing where no mass is exchanged.
struct MassExchange {
  static constexpr const char* name = "mass exchange";
  static constexpr bool over_pairs = true;
  using Reads = List<Position, Velocity, Mass, Support, InverseSupport, Pressure, InverseDensity, MassRate,
                     MassMomentum, MassEnergy, Acceleration, Heating>;
  using Writes = List<Acceleration, Heating>;
  using Keeps = List<HalfStepMass, MassDensityRate>;
  using Numbers = sphk::Numbers<mass_form>;
  using Sums = TermSet<MassDensityRateSum>;
  template <class S>
  static void run(RunOf<typename S::Layout>& run, const SmoothingOf<S>& smoothing) {
    using L = typename S::Layout;
    const State<S> state{run.state.template as<L>(), smoothing};
    const Kokkos::RangePolicy<ExecutionSpace> all(0, state.n);
    int any = 0;
    Kokkos::parallel_reduce("any exchange of mass", all, detail::AnyMassRate<L>{state}, Kokkos::LOr<int>(any));
    if (!any) return;
    const MassForm form = mass_form_of(run.given);
    Kokkos::parallel_for(name, all, detail::CorrectForMass<L>{state, form});
    // Where u is integrated it does not change with rho.
    if constexpr (std::is_same_v<typename L::ThermalForm, EntropyForm>) {
      if (!form.paid) return;
      add_pair_sums<Reach::gather>("rho's change by exchange", state, Sums(run.given), state.columns);
      Kokkos::parallel_for(name, all, detail::PayForDensity<L>{state});
    }
  }
};

}  // namespace sphk
