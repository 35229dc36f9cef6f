// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/rates.hpp"
#include "kernels/passes/run.hpp"
#include "kernels/passes/state_equation.hpp"
#include "kernels/terms/free_functions.hpp"
#include "kernels/terms/general_density.hpp"

namespace sphk {

namespace detail {

/// The gas whose thermal variable is s, at density rho.
template <class Form>
KOKKOS_INLINE_FUNCTION GasValues values_of_gas(double s, double rho, double gamma) {
  const double P = Form::pressure(s, rho, gamma);
  return {rho, P, P / ((gamma - 1) * rho), P / Kokkos::pow(rho, gamma), gamma};
}

/// Particle i's gas at density rho.
template <class L>
KOKKOS_INLINE_FUNCTION GasValues gas_values(const Particles<L>& state, int i, double rho) {
  return values_of_gas<typename L::ThermalForm>(state.template at<Thermal>(i), rho, state.parameters.gamma);
}

/// 1/eta of the observable density: what enters the sum for the other one.
template <class L, class Eta>
struct TakeInverseEta {
  Particles<L> state;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    state.template at<InverseEta>(i) = 1 / Eta::value(gas_values(state, i, state.template at<Density>(i)));
  }
};

/// rho of rho/eta; of gas without heat, whose 1/eta is 0, the observable density.
template <class L>
struct TakeGeneralDensity {
  Particles<L> state;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    if (!state.active.contains(i)) return;
    const double eta_inv = state.template at<InverseEta>(i);
    double& rho = state.template at<GeneralDensity>(i);
    rho = eta_inv > 0 ? rho / eta_inv : state.template at<Density>(i);
  }
};

template <class L, class Phi, class Zeta>
struct EvaluateFreeFunctions {
  Particles<L> state;
  template <class F>
  KOKKOS_INLINE_FUNCTION void set(int i, double value) const {
    if constexpr (contains<F, typename L::Fields>) state.template at<F>(i) = value;
  }
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    const double rho = state.state_density(i);
    const GasValues gas = gas_values(state, i, rho);
    const double phi = Phi::value(gas), zeta = Zeta::value(gas);
    set<InversePhi>(i, 1 / phi);
    set<PhiPressure>(i, gas.P > 0 ? gas.P * (phi / rho) * (phi / rho) : 0);
    set<InverseZeta>(i, 1 / zeta);
    set<ZetaPressure>(i, gas.P > 0 ? gas.P * zeta / (rho * rho) : 0);
  }
};

/// z of the pseudo-coherent forces: -(h/(D n)) d(rho/eta)/dh over Omega.
template <class L>
struct EvaluateGeneralGradH {
  Particles<L> state;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    if (!state.active.contains(i)) return;
    state.template at<GradHMass>(i) = grad_h_mass(state, i, state.template at<GeneralDensitySlope>(i));
  }
};

}  // namespace detail

/// The density of the generalised continuity equation, rho_i = eta_i sum_j (m_j/eta_j) Wbar (R10 eq 19): with eta = 1/u
/// or A^(-1/gamma) that of Ritchie & Thomas (2001), whose pressures are smooth where fluids meet (R10 eq 35, 36, 54).
template <class FreeEta>
struct GeneralContinuity {
  using Eta = FreeEta;
  static constexpr const char* name = "generalised density";
  static constexpr bool over_pairs = true;
  using Reads = List<Position, InverseSupport, Mass, Thermal, Density>;
  using Writes = List<InverseEta, GeneralDensity>;
  using Keeps = Writes;
  using Sums = TermSet<GeneralDensitySum>;
  template <class S>
  static void run(RunOf<typename S::Layout>& run, const SmoothingOf<S>& smoothing) {
    sum_up<Reach::symmetric, Sums, S>(run, smoothing);
  }

 protected:
  template <Reach reach, class SumsOfPairs, class S>
  static void sum_up(RunOf<typename S::Layout>& run, const SmoothingOf<S>& smoothing) {
    using L = typename S::Layout;
    const State<S> state{run.state.template as<L>(), smoothing};
    const Kokkos::RangePolicy<ExecutionSpace> all(0, state.n);
    Kokkos::parallel_for("1/eta", all, detail::TakeInverseEta<L, FreeEta>{state});
    add_pair_sums<reach>(name, state, SumsOfPairs(run.given), state.columns);
    Kokkos::parallel_for(name, all, detail::TakeGeneralDensity<L>{state});
  }
};

/// The same with W(r_ij, h_i) in place of Wbar, and what the gradient of h adds to the forces of that density (R10
/// footnote 4).
template <class FreeEta>
struct CoherentContinuity : GeneralContinuity<FreeEta> {
  using Reads = Union<typename GeneralContinuity<FreeEta>::Reads, List<Support, NumberDensity, NumberDensitySlope>>;
  using Writes = List<InverseEta, GeneralDensity, GeneralDensitySlope, GradHMass>;
  using Keeps = Writes;
  using Sums = TermSet<GeneralDensitySum, GeneralDensitySlopeSum>;
  template <class S>
  static void run(RunOf<typename S::Layout>& run, const SmoothingOf<S>& smoothing) {
    using L = typename S::Layout;
    CoherentContinuity::template sum_up<Reach::gather, Sums, S>(run, smoothing);
    Kokkos::parallel_for("grad-h", Kokkos::RangePolicy<ExecutionSpace>(0, run.state.n),
                         detail::EvaluateGeneralGradH<L>{run.state.template as<L>()});
  }
};

/// What forces and work take of phi and zeta.
template <class Phi, class Zeta>
struct FreeFunctions {
  static constexpr const char* name = "free functions";
  using Reads = List<Thermal, GeneralDensity>;
  using Writes = List<InversePhi, PhiPressure, InverseZeta, ZetaPressure>;
  template <class L>
  static void run(RunOf<L>& run) {
    Kokkos::parallel_for(name, Kokkos::RangePolicy<ExecutionSpace>(0, run.state.n),
                         detail::EvaluateFreeFunctions<L, Phi, Zeta>{run.state.template as<L>()});
  }
};

/// Pressures smoothed over the neighbours (V10 eq 7).
struct SmoothedPressures {
  static constexpr const char* name = "smoothed pressures";
  static constexpr bool over_pairs = true;
  using Reads = List<Position, InverseSupport, Mass, Pressure, InverseDensity>;
  using Writes = List<SmoothedPressure>;
  using Keeps = Writes;
  using Sums = TermSet<SmoothedPressureSum>;
  template <class S>
  static void run(RunOf<typename S::Layout>& run, const SmoothingOf<S>& smoothing) {
    const State<S> state{run.state.template as<typename S::Layout>(), smoothing};
    add_pair_sums(name, state, Sums(run.given), state.columns);
  }
};

}  // namespace sphk
