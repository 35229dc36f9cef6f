// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/general_density.hpp"
#include "src/engine/error_sums.hpp"
#include "src/engine/host_columns.hpp"
#include "src/engine/scheme.hpp"

namespace sphk {

namespace detail {

// The free function phi or eta of R10 that a term or pass names, if it does.
template <class T>
auto phi(int) -> List<typename T::Phi>;
template <class T>
auto phi(long) -> List<>;
template <class P>
auto eta(int) -> List<typename P::Eta>;
template <class P>
auto eta(long) -> List<>;
template <class First, class... Rest>
auto first(List<First, Rest...>) -> First;
/// The first that a scheme's terms or passes name; 1 where none does.
template <class... T>
auto phi_of(List<T...>) -> decltype(first(Union<decltype(phi<T>(0))..., List<One>>{}));
template <class... P>
auto eta_of(List<P...>) -> decltype(first(Union<decltype(eta<P>(0))..., List<One>>{}));

template <class L, class Phi, class Eta>
struct FillErrorColumns {
  static constexpr int D = L::dimension;
  Particles<L> state;
  Columns<D, typename ErrorLayout<D>::Fields> out;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    for (int d = 0; d < D; ++d) out.template at<Position>(i, d) = state.template at<Position>(i, d);
    const double h = state.template at<Support>(i);
    const GasValues gas = gas_values(state, i, state.state_density(i));
    out.template at<Mass>(i) = state.template at<Mass>(i);
    out.template at<Support>(i) = h;
    out.template at<InverseSupport>(i) = 1 / h;
    out.template at<Density>(i) = gas.rho;
    out.template at<InversePhi>(i) = positive(1 / Phi::value(gas));
    out.template at<InverseEta>(i) = positive(1 / Eta::value(gas));
    out.template at<EtaRate>(i) = eta_rate(i, gas);
    out.template at<Entropy>(i) = gas.A;
  }
  /// Of gas without heat 1/u is infinite: a ratio of such particles is 1 then, not NaN.
  KOKKOS_INLINE_FUNCTION static double positive(double x) { return max(x, 1e-150); }
  /// d ln(eta)/dt along the way that the particle's gas takes, as a central difference over a time in which nothing
  /// changes by more than 1e-5 of itself: an eta needs no more than its value.
  KOKKOS_INLINE_FUNCTION double eta_rate(int i, const GasValues& gas) const {
    const double s = state.template at<Thermal>(i);
    const double thermal = s > 0 ? state.template at<Heating>(i) / s : 0;
    double density = 0;  // (drho/dt)/rho
    if constexpr (contains<VelocityDivergence, typename L::Fields>) density = -state.template at<VelocityDivergence>(i);
    const double fastest = max(abs(thermal), abs(density));
    if (!(fastest > 0 && Kokkos::isfinite(fastest))) return 0;
    const double dt = 1e-5 / fastest;
    const auto eta_after = [&](double t) {
      const double rho = gas.rho * (1 + density * t), s_then = s * (1 + thermal * t);
      return Eta::value(values_of_gas<typename L::ThermalForm>(s_then, rho, gas.gamma));
    };
    return Kokkos::log(eta_after(dt) / eta_after(-dt)) / (2 * dt);
  }
};

}  // namespace detail

/// What the errors of a recipe are judged by, for its particles: Columns of ErrorLayout.
template <class R, class L>
Particles<ErrorLayout<L::dimension>> error_particles(const Particles<L>& state) {
  constexpr int D = L::dimension;
  using Phi = decltype(detail::phi_of(typename R::RateTerms::List{}));
  using Eta = decltype(detail::eta_of(typename R::StepPasses{}));
  Particles<ErrorLayout<D>> particles{state.n, error_columns<D>(state.n), state.ids, state.tree, state.parameters};
  Kokkos::parallel_for("columns for errors", Kokkos::RangePolicy<ExecutionSpace>(0, state.n),
                       detail::FillErrorColumns<L, Phi, Eta>{state, particles.columns});
  return particles;
}

}  // namespace sphk
