// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/run.hpp"
#include "kernels/passes/state_equation.hpp"
#include "kernels/terms/switched_pair.hpp"

namespace sphk {

inline constexpr Number switch_alpha_min{
    .key = "switch.alpha_min", .standard = 0.2, .meaning = "what alpha decays to (S12 eq 23)", .max = 1};
inline constexpr Number switch_noise{
    .key = "switch.noise", .standard = 0.05, .meaning = "n_s, noise that the switch bears (S12 eq 21)", .max = 100};
inline constexpr Number switch_balsara{.key = "switch.balsara",
                                       .standard = 1,
                                       .meaning = "which dissipations Balsara's factor limits",
                                       .max = 1,
                                       .words = "viscosity|all"};

namespace detail {

/// alpha_loc of S12 eq 21 with alpha_max = 1: in [0, 1), zero where the flow does not converge.
KOKKOS_INLINE_FUNCTION double local_alpha(double h, double div_v, double grad_div_v, double noise_speed) {
  if (!(div_v < 0)) return 0;
  const double jump = h * h * grad_div_v, sum = jump + h * abs(div_v) + noise_speed;
  return sum > 0 ? jump / sum : 0;
}

template <class L>
struct SwitchAlpha {
  Particles<L> state;
  double alpha_min, noise;
  double limited;  ///< 1 where Balsara's factor limits every dissipation, 0 where the viscosity alone

  SwitchAlpha(const Particles<L>& of, const Given& given)
      : state(of), alpha_min(given[switch_alpha_min]), noise(given[switch_noise]), limited(given[switch_balsara]) {}

  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    if (!state.active.contains(i)) return;
    const auto v = state.columns.template load<List<VelocityDivergence, VelocityCurl, GradVelocityDivergence>>(i);
    const double h = state.template at<Support>(i), c = state.template at<SoundSpeed>(i);
    const double loc = local_alpha(h, v.div_v, length(v.grad_div_v), noise * c);
    double& alpha = state.template at<Alpha>(i);
    if (alpha < loc) {
      alpha = loc;  // S12 eq 22
    } else {        // S12 eq 23 over the step that ends, tau = h / v_max
      const double target = loc > alpha_min ? loc : alpha_min;
      const double decay = Kokkos::exp(-state.clock.step_of(i) * state.template at<MaxSignalVelocity>(i) / h);
      alpha = target + (alpha - target) * decay;
    }
    const double balsara = balsara_factor(v.div_v, length(v.curl_v), c, h);
    set<ViscosityAlpha>(i, balsara * alpha);
    set<DissipationAlpha>(i, (1 - limited + limited * balsara) * alpha);
  }
  template <class F>
  KOKKOS_INLINE_FUNCTION void set(int i, double value) const {
    if constexpr (contains<F, typename L::Fields>) state.template at<F>(i) = value;
  }
};

}  // namespace detail

/// The convergence switch of S12 eq 21-25: alpha rises at once where the flow is going to converge and decays after;
/// Balsara's factor (S12 eq 32) with the fitted gradients multiplies what the terms use.
struct ConvergenceSwitch {
  static constexpr const char* name = "convergence switch";
  using Reads = List<Support, SoundSpeed, VelocityDivergence, VelocityCurl, GradVelocityDivergence>;
  using Remembers = List<Alpha, MaxSignalVelocity>;
  using Writes = List<Alpha, ViscosityAlpha, DissipationAlpha>;
  using Keeps = List<Alpha>;
  using Numbers = sphk::Numbers<switch_alpha_min, switch_noise, switch_balsara>;
  template <class L>
  static void run(RunOf<L>& run) {
    Kokkos::parallel_for(name, Kokkos::RangePolicy<ExecutionSpace>(0, run.state.n),
                         detail::SwitchAlpha<L>(run.state.template as<L>(), run.given));
  }
};

/// One alpha for all particles in place of what the switch says (S12 App. C).
struct GivenAlpha {
  static constexpr const char* name = "given alpha";
  using Reads = List<>;
  using Writes = List<ViscosityAlpha, DissipationAlpha>;
  using Numbers = sphk::Numbers<switch_alpha>;
  static bool wanted(const Given& given) { return given[switch_alpha] >= 0; }
  template <class L>
  static void run(RunOf<L>& run) {
    const double alpha = run.given[switch_alpha];
    fill<ViscosityAlpha, L>(run, alpha);
    fill<DissipationAlpha, L>(run, alpha);
  }
};

}  // namespace sphk
