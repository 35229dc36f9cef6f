// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/kick_drift.hpp"
#include "kernels/passes/run.hpp"
#include "kernels/terms/pair_limiter.hpp"

namespace sphk {

/// The scheme integrates the entropy function A, P = A rho^gamma; du/dt of dissipation feeds it.
struct EntropyForm {
  static constexpr const char* name = "entropy";
  static constexpr const char* left_out = "pressure work: the entropy function changes by dissipation alone";
  KOKKOS_INLINE_FUNCTION static double pressure(double A, double rho, double gamma) {
    return A * Kokkos::pow(rho, gamma);
  }
  /// dA/dt = (gamma-1) rho^(1-gamma) du/dt (S12 eq 31).
  KOKKOS_INLINE_FUNCTION static double rate(double du, double rho, double gamma) {
    return du == 0 ? 0 : (gamma - 1) * Kokkos::pow(rho, 1 - gamma) * du;
  }
  /// dA/dt from the rate of the integrated variable; `work` is P/rho^2 drho/dt, which A does not feel.
  KOKKOS_INLINE_FUNCTION static double entropy_rate(double dA, double, double, double) { return dA; }
  KOKKOS_INLINE_FUNCTION static double from_energy(double u, double rho, double gamma) {
    return (gamma - 1) * u * Kokkos::pow(rho, 1 - gamma);
  }
  /// P'/P at constant A where rho'/rho = exp(compression) = `denser`.
  KOKKOS_INLINE_FUNCTION static double pressure_growth(double compression, double, double gamma) {
    return detail::small_exp(gamma * compression);
  }
};

/// The scheme integrates the specific energy u, P = (gamma-1) rho u.
struct EnergyForm {
  static constexpr const char* name = "energy";
  static constexpr const char* left_out = nullptr;
  KOKKOS_INLINE_FUNCTION static double pressure(double u, double rho, double gamma) { return (gamma - 1) * rho * u; }
  KOKKOS_INLINE_FUNCTION static double rate(double du, double, double) { return du; }
  KOKKOS_INLINE_FUNCTION static double entropy_rate(double du, double work, double rho, double gamma) {
    return (gamma - 1) * Kokkos::pow(rho, 1 - gamma) * (du - work);
  }
  KOKKOS_INLINE_FUNCTION static double from_energy(double u, double, double) { return u; }
  KOKKOS_INLINE_FUNCTION static double pressure_growth(double, double denser, double) { return denser; }
};

namespace detail {

/// |div v| / (|div v| + |curl v| + 1e-4 c/h) (S12 eq 32).
KOKKOS_INLINE_FUNCTION double balsara_factor(double div_v, double curl_v, double c, double h) {
  const double div = abs(div_v), sum = div + curl_v + 1e-4 * c / h;
  return sum > 0 ? div / sum : 1;
}

template <class L, class StateDensity>
struct EvaluateState {
  Particles<L> state;

  template <class F>
  KOKKOS_INLINE_FUNCTION void set(int i, double value) const {
    if constexpr (contains<F, typename L::Fields>) state.template at<F>(i) = value;
  }

  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    if (!state.active.contains(i)) return;
    const double rho = state.template at<StateDensity>(i);
    const double gamma = state.parameters.gamma;
    const double P = L::ThermalForm::pressure(state.template at<Thermal>(i), rho, gamma);
    const double c = Kokkos::sqrt(gamma * P / rho);
    set<Pressure>(i, P);
    set<PressureOverDensity2>(i, P / (rho * rho));
    set<InverseDensity>(i, 1 / rho);
    set<SoundSpeed>(i, c);
  }
};

template <class L>
struct EvaluateBalsara {
  Particles<L> state;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    if (!state.active.contains(i)) return;
    const auto v = state.columns.template load<List<VelocityDivergence, VelocityCurl, SoundSpeed, Support>>(i);
    state.template at<Balsara>(i) = balsara_factor(v.div_v, length(v.curl_v), v.c, v.h);
  }
};

/// z = -(h/(D n)) dq/dh / Omega, Omega = 1 + (h/(D n)) dn/dh: what the gradient of h adds to the masses in the gradient
/// of a sum q whose slope in h is given (EQUATIONS, Momentum).
template <class L>
KOKKOS_INLINE_FUNCTION double grad_h_mass(const Particles<L>& state, int i, double slope) {
  const double h_Dn = state.template at<Support>(i) / (L::dimension * state.template at<NumberDensity>(i));
  const double Omega = 1 + h_Dn * state.template at<NumberDensitySlope>(i);
  // Omega vanishes where the support holds coincident particles alone: h is free there, and has no gradient.
  return Omega > 1e-8 ? -h_Dn * slope / Omega : 0;
}

template <class L>
struct EvaluateGradH {
  Particles<L> state;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    if (!state.active.contains(i)) return;
    state.template at<GradHMass>(i) = grad_h_mass(state, i, state.template at<DensitySlope>(i));
  }
};

}  // namespace detail

/// Pressure and sound speed of a density, that of the equations of motion: what the terms read beside it.
template <class Density>
struct EquationOfState {
  using StateDensity = Density;
  static constexpr const char* name = "equation of state";
  using Reads = List<Density, Thermal>;
  using Writes = List<Pressure, PressureOverDensity2, InverseDensity, SoundSpeed>;
  using Numbers = sphk::Numbers<adiabatic_index>;
  template <class L>
  static void run(RunOf<L>& run) {
    Kokkos::parallel_for(name, Kokkos::RangePolicy<ExecutionSpace>(0, run.state.n),
                         detail::EvaluateState<L, Density>{run.state.template as<L>()});
  }
};
using StateEquation = EquationOfState<Density>;

/// Balsara's factor, with which classic schemes limit their viscosity (S12 eq 32);
struct BalsaraFactor {
  static constexpr const char* name = "Balsara's factor";
  using Reads = List<VelocityDivergence, VelocityCurl, SoundSpeed, Support>;
  using Writes = List<Balsara>;
  static bool wanted(const Given& given) { return given[viscosity_balsara] != 0; }
  template <class L>
  static void run(RunOf<L>& run) {
    Kokkos::parallel_for(name, Kokkos::RangePolicy<ExecutionSpace>(0, run.state.n),
                         detail::EvaluateBalsara<L>{run.state.template as<L>()});
  }
};
/// or 1 in its place.
struct NoBalsaraFactor {
  static constexpr const char* name = "no Balsara factor";
  using Reads = List<>;
  using Writes = List<Balsara>;
  static bool wanted(const Given& given) { return !BalsaraFactor::wanted(given); }
  template <class L>
  static void run(RunOf<L>& run) {
    fill<Balsara, L>(run, 1);
  }
};

/// z of the conservative momentum equation, from dn/dh and drho/dh.
struct GradH {
  static constexpr const char* name = "grad-h";
  using Reads = List<Support, NumberDensity, NumberDensitySlope, DensitySlope>;
  using Writes = List<GradHMass>;
  using Keeps = Writes;
  template <class L>
  static void run(RunOf<L>& run) {
    Kokkos::parallel_for(name, Kokkos::RangePolicy<ExecutionSpace>(0, run.state.n),
                         detail::EvaluateGradH<L>{run.state.template as<L>()});
  }
};

}  // namespace sphk
