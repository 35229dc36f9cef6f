#pragma once

#include "kernels/passes/run.hpp"

namespace sphk {

namespace detail {

/// s + ds, but never below zero: beyond half of s the loss turns into an exponential decay (value and slope
/// continuous).
KOKKOS_INLINE_FUNCTION double positive_sum(double s, double ds) {
  return ds >= -0.5 * s ? s + ds : 0.5 * s * Kokkos::exp(2 * ds / s + 1);
}

template <class L>
struct KickAndDrift {
  Particles<L> state;
  double dt;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    constexpr int D = L::dimension;
    for (int d = 0; d < D; ++d) {
      const double half_kick = 0.5 * dt * state.template at<Acceleration>(i, d);
      const double v_half = state.template at<Velocity>(i, d) + half_kick;
      state.template at<HalfStepVelocity>(i, d) = v_half;
      state.template at<Velocity>(i, d) = v_half + half_kick;
      state.template at<Position>(i, d) += v_half * dt;
    }
    const double half_kick = 0.5 * dt * state.template at<ThermalRate>(i);
    const double s_half = positive_sum(state.template at<Thermal>(i), half_kick);
    state.template at<HalfStepThermal>(i) = s_half;
    state.template at<Thermal>(i) = positive_sum(s_half, half_kick);
    if constexpr (contains<VelocityDivergence, typename L::Fields>) {
      double& h = state.template at<Support>(i);
      const double slope = h * state.template at<NumberDensitySlope>(i) / state.template at<NumberDensity>(i);
      // D + slope = 0 where the support holds coincident particles alone.
      const double growth = dt * state.template at<VelocityDivergence>(i) / max(D + slope, 0.1);
      h *= Kokkos::exp(min(max(growth, -0.2), 0.2));
    }
  }
};

template <class L>
struct ClosingKick {
  Particles<L> state;
  double dt;
  KOKKOS_INLINE_FUNCTION void operator()(int i, StepLimit& limit) const {
    constexpr int D = L::dimension;
    double sum = 0;  // not finite where anything of the particle is not
    for (int d = 0; d < D; ++d) {
      double& v = state.template at<Velocity>(i, d);
      v = state.template at<HalfStepVelocity>(i, d) + 0.5 * dt * state.template at<Acceleration>(i, d);
      sum += v;
    }
    if constexpr (contains<Heating, typename L::Fields>) {
      const double ds =
          L::ThermalForm::rate(state.template at<Heating>(i), state.template at<Density>(i), state.parameters.gamma);
      state.template at<ThermalRate>(i) = ds;
      state.template at<Thermal>(i) = positive_sum(state.template at<HalfStepThermal>(i), 0.5 * dt * ds);
    }
    const double asked =
        state.parameters.courant * state.template at<Support>(i) / state.template at<MaxSignalVelocity>(i);
    sum += state.template at<Thermal>(i);
    limit += {asked > 0 && Kokkos::isfinite(sum) ? asked : 0, i};
  }
};

}  // namespace detail

/// Opening kick over half a step, drift over a whole one, velocities and thermal variable predicted to its end; the
/// support follows the expansion: h^D n stays N_n / V_D while dn/dt = -n div v + dn/dh dh/dt.
struct KickDrift {
  static constexpr const char* name = "kick and drift";
  using Writes = List<Position, Velocity, HalfStepVelocity, Thermal, HalfStepThermal, Support>;
  template <class S>
  static void run(Run<S>& run) {
    Kokkos::parallel_for(name, Kokkos::RangePolicy<ExecutionSpace>(0, run.state.n),
                         detail::KickAndDrift<typename S::Layout>{run.state, run.dt});
  }
};

/// Closing half kick, and the next time-step dt = min C h_i / v_max,i (S12 eq 43).
struct KickTimeStep {
  static constexpr const char* name = "kick and time-step";
  using Writes = List<ThermalRate>;
  template <class S>
  static void run(Run<S>& run) {
    run.limit = {};
    if (run.state.n == 0) return;
    Kokkos::parallel_reduce(name, Kokkos::RangePolicy<ExecutionSpace>(0, run.state.n),
                            detail::ClosingKick<typename S::Layout>{run.state, run.dt},
                            Kokkos::Sum<StepLimit>(run.limit));
  }
};

}  // namespace sphk
