#pragma once

#include "kernels/passes/run.hpp"
#include "kernels/passes/state_equation.hpp"

namespace sphk {

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

  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    if (!state.active.contains(i)) return;
    const Parameters& p = state.parameters;
    const auto v = state.columns.template load<List<VelocityDivergence, VelocityCurl, GradVelocityDivergence>>(i);
    const double h = state.template at<Support>(i), c = state.template at<SoundSpeed>(i);
    const double loc = local_alpha(h, v.div_v, length(v.grad_div_v), p.noise * c);
    double& alpha = state.template at<Alpha>(i);
    if (alpha < loc) {
      alpha = loc;  // S12 eq 22
    } else {        // S12 eq 23 over the step that ends, tau = h / v_max
      const double target = loc > p.alpha_min ? loc : p.alpha_min;
      const double decay = Kokkos::exp(-state.clock.step_of(i) * state.template at<MaxSignalVelocity>(i) / h);
      alpha = target + (alpha - target) * decay;
    }
    const double balsara = balsara_factor(v.div_v, length(v.curl_v), c, h);
    const bool given = p.alpha_given >= 0;
    state.template at<ViscosityAlpha>(i) = given ? p.alpha_given : balsara * alpha;
    state.template at<DissipationAlpha>(i) = given ? p.alpha_given : p.balsara_limits_all ? balsara * alpha : alpha;
  }
};

}  // namespace detail

/// The convergence switch of S12 eq 21-25: alpha rises at once where the flow is going to converge and decays after;
/// Balsara's factor (S12 eq 32) with the fitted gradients multiplies what the terms use.
struct ConvergenceSwitch {
  static constexpr const char* name = "convergence switch";
  using Writes = List<Alpha, ViscosityAlpha, DissipationAlpha>;
  using Keeps = List<Alpha>;
  template <class L>
  static void run(RunOf<L>& run) {
    Kokkos::parallel_for(name, Kokkos::RangePolicy<ExecutionSpace>(0, run.state.n),
                         detail::SwitchAlpha<L>{run.state.template as<L>()});
  }
};

}  // namespace sphk
