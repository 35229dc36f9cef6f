// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/run.hpp"

namespace sphk {

inline constexpr Number motion{
    .key = "time.motion",
    .standard = 1,
    .meaning = "false: particles keep their places and velocities and only exchange heat and mass",
    .max = 1,
    .words = off_or_on};

namespace detail {

/// s + ds, but never below zero: beyond half of s the loss turns into an exponential decay (value and slope
/// continuous), and is counted.
KOKKOS_INLINE_FUNCTION double positive_sum(double s, double ds, long& softened) {
  if (ds >= -0.5 * s) return s + ds;
  ++softened;
  return 0.5 * s * Kokkos::exp(2 * ds / s + 1);
}

/// exp(x) for |x| up to 0.4, to 1e-4: what a prediction needs.
KOKKOS_INLINE_FUNCTION double small_exp(double x) {
  x = min(max(x, -0.4), 0.4);
  return 1 + x * (1 + x * (1.0 / 2 + x * (1.0 / 6 + x * (1.0 / 24))));
}

}  // namespace detail

/// Fields that the prediction of sleeping particles changes, of those that a scheme has.
using PredictedFields = List<Velocity, Thermal, Mass, Support, InverseSupport, Density, GeneralDensity, InverseDensity,
                             Pressure, SmoothedPressure, PressureOverDensity2, SoundSpeed>;

namespace detail {

/// How a particle gets through a step before its forces are known.
template <class L>
struct Motion {
  static constexpr int D = L::dimension;
  using Fields = typename L::Fields;
  Particles<L> state;

  /// Opening kick over half a step.
  KOKKOS_INLINE_FUNCTION void open(int i, double half, LossCounts& losses) const {
    const double kick = half * state.clock.mobility;
    for (int d = 0; d < D; ++d)
      state.template at<HalfStepVelocity>(i, d) =
          state.template at<Velocity>(i, d) + kick * state.template at<Acceleration>(i, d);
    state.template at<HalfStepThermal>(i) =
        positive_sum(state.template at<Thermal>(i), half * state.template at<Heating>(i), losses.heat);
    if constexpr (contains<MassRate, Fields>)
      state.template at<HalfStepMass>(i) =
          positive_sum(state.template at<Mass>(i), half * state.template at<MassRate>(i), losses.mass);
  }
  KOKKOS_INLINE_FUNCTION void drift(int i, double dt) const {
    const double moved = dt * state.clock.mobility;
    for (int d = 0; d < D; ++d) state.template at<Position>(i, d) += moved * state.template at<HalfStepVelocity>(i, d);
  }
  /// What pairs read beside the position, dt later.
  KOKKOS_INLINE_FUNCTION void predict(int i, double dt) const {
    LossCounts predicted;  // the closing kick takes their place
    const double moved = dt * state.clock.mobility;
    for (int d = 0; d < D; ++d) state.template at<Velocity>(i, d) += moved * state.template at<Acceleration>(i, d);
    double& s = state.template at<Thermal>(i);
    const double s_before = s;
    s = positive_sum(s, dt * state.template at<Heating>(i), predicted.heat);
    if constexpr (contains<MassRate, Fields>) {
      double& m = state.template at<Mass>(i);
      m = positive_sum(m, dt * state.template at<MassRate>(i), predicted.mass);
    }
    if constexpr (contains<VelocityDivergence, Fields>) {
      const double expansion = dt * state.template at<VelocityDivergence>(i);
      double& h = state.template at<Support>(i);
      const double slope = h * state.template at<NumberDensitySlope>(i) / state.template at<NumberDensity>(i);
      // D + slope = 0 where the support holds coincident particles alone.
      h *= small_exp(min(max(expansion / max(D + slope, 0.1), -0.2), 0.2));
      if (state.clock.individual) predict_gas(i, expansion, s_before > 0 ? s / s_before : 1);
    }
  }

 private:
  template <class F>
  KOKKOS_INLINE_FUNCTION void scale(int i, double factor) const {
    static_assert(contains<F, PredictedFields>);
    if constexpr (contains<F, Fields>) state.template at<F>(i) *= factor;
  }
  /// Of particles that are not computed at the end of this step: their gas expands, and heats.
  KOKKOS_INLINE_FUNCTION void predict_gas(int i, double expansion, double heated) const {
    const double thinner = small_exp(-expansion);  // rho' / rho
    const double P = L::ThermalForm::pressure_growth(-expansion, thinner, state.parameters.gamma) * heated;
    scale<Density>(i, thinner);
    scale<GeneralDensity>(i, thinner);
    scale<InverseDensity>(i, 1 / thinner);
    scale<Pressure>(i, P);
    scale<SmoothedPressure>(i, P);
    scale<PressureOverDensity2>(i, P / (thinner * thinner));
    scale<SoundSpeed>(i, Kokkos::sqrt(P / thinner));
    if constexpr (contains<InverseSupport, Fields>)
      state.template at<InverseSupport>(i) = 1 / state.template at<Support>(i);
  }
};

/// One step for all.
template <class L>
struct KickAndDrift {
  Motion<L> motion;
  KOKKOS_INLINE_FUNCTION void operator()(int i, LossCounts& losses) const {
    const double dt = motion.state.clock.dt;
    motion.open(i, 0.5 * dt, losses);
    motion.drift(i, dt);
    motion.predict(i, dt);
  }
};

/// Brings all of a cell's particles to where their positions are.
template <class L>
KOKKOS_INLINE_FUNCTION void predict_cell(const Motion<L>& motion, int cell) {
  double& late = motion.state.clock.late(cell);
  if (late > 0)
    for (int i = cell * cell_size, end = min(i + cell_size, motion.state.n); i < end; ++i) motion.predict(i, late);
  late = 0;
}

/// Steps of the particles' own: all are moved, and predicted are those alone whose steps begin.
template <class L>
struct KickAndDriftCell {
  Motion<L> motion;
  KOKKOS_INLINE_FUNCTION void operator()(int cell, LossCounts& losses) const {
    const StepClock& clock = motion.state.clock;
    const int begin = cell * cell_size, end = min(begin + cell_size, motion.state.n);
    bool any = false;
    for (int i = begin; i < end; ++i) any = any || clock.opens(i);
    if (any) {
      predict_cell(motion, cell);
      for (int i = begin; i < end; ++i)
        if (clock.opens(i)) motion.open(i, 0.5 * clock.step_of(i), losses);
    }
    for (int i = begin; i < end; ++i) motion.drift(i, clock.dt);
    clock.late(cell) += clock.dt;
  }
};

template <class L>
struct PredictCells {
  Motion<L> motion;
  ParticleSubset cells;
  KOKKOS_INLINE_FUNCTION void operator()(int k) const { predict_cell(motion, cells.cell(k)); }
};

template <class L>
struct ClosingKick {
  static constexpr int D = L::dimension;
  using Fields = typename L::Fields;
  Particles<L> state;

  KOKKOS_INLINE_FUNCTION void operator()(int i, StepLimit& limit, LossCounts& losses) const {
    if (!state.active.contains(i)) return;
    const double half = 0.5 * state.clock.step_of(i), kick = half * state.clock.mobility;
    double sum = 0;  // not finite where anything of the particle is not
    for (int d = 0; d < D; ++d) {
      double& v = state.template at<Velocity>(i, d);
      v = state.template at<HalfStepVelocity>(i, d) + kick * state.template at<Acceleration>(i, d);
      sum += v;
    }
    double& rate = state.template at<Heating>(i);
    rate = L::ThermalForm::rate(rate, state.state_density(i), state.parameters.gamma);
    state.template at<Thermal>(i) = positive_sum(state.template at<HalfStepThermal>(i), half * rate, losses.heat);
    if constexpr (contains<MassRate, Fields>)
      state.template at<Mass>(i) =
          positive_sum(state.template at<HalfStepMass>(i), half * state.template at<MassRate>(i), losses.mass);
    sum += state.template at<Thermal>(i);
    const double asked = state.step_asked(i);
    limit += {asked > 0 && Kokkos::isfinite(sum) ? asked : 0, i};
  }
};

}  // namespace detail

/// Predicts what pairs read of the particles of some cells, beside their positions, to the present time.
template <class L>
void predict(const RunOf<L>& run, const ParticleSubset& cells) {
  const Particles<L> state = run.state.template as<L>();
  if (!state.clock.individual) return;
  Kokkos::parallel_for("predict", Kokkos::RangePolicy<ExecutionSpace>(0, cells.cells(state.tree)),
                       detail::PredictCells<L>{{state}, cells});
}

/// Opening kick over half a step of the particles whose step begins, drift of all, everything predicted to the drift's
/// end; the support follows the expansion: h^D n stays N_n / V_D while dn/dt = -n div v + dn/dh dh/dt. With steps of
/// the particles' own only positions are; the rest waits until pairs read it (ActiveParticles).
struct KickDrift {
  static constexpr const char* name = "kick and drift";
  static constexpr bool essential = true;
  using Reads = List<>;
  using Remembers = List<Acceleration, Heating, NumberDensity, NumberDensitySlope>;
  using MayRemember = List<VelocityDivergence, MassRate>;
  using Writes = List<Position, Velocity, HalfStepVelocity, Thermal, HalfStepThermal, Support>;
  using Numbers = sphk::Numbers<motion>;
  template <class L>
  static void run(RunOf<L>& run) {
    const detail::Motion<L> particles{run.state.template as<L>()};
    LossCounts losses;
    const auto reduce = [&](int count, const auto& body) {
      Kokkos::parallel_reduce(name, Kokkos::RangePolicy<ExecutionSpace>(0, count), body,
                              Kokkos::Sum<LossCounts>(losses));
    };
    if (run.state.clock.individual)
      reduce(run.state.tree.cells(), detail::KickAndDriftCell<L>{particles});
    else
      reduce(run.state.n, detail::KickAndDrift<L>{particles});
    run.counts.losses = losses;
  }
};

/// The pull of a central mass, beside the forces of the pairs.
struct CentralPull {
  static constexpr const char* name = "central mass";
  static constexpr bool essential = true;
  using Reads = List<Position, Acceleration>;
  using Writes = List<Acceleration>;
  using Numbers = sphk::Numbers<central_mass, gravity_softening>;
  static bool wanted(const Given& given) { return given[central_mass] > 0; }
  template <class L>
  static void run(RunOf<L>& run) {
    pull_to_centre(run.state);
  }
};

/// Closing half kick of the active particles, and the time-steps that they ask for.
struct KickTimeStep {
  static constexpr const char* name = "kick and time-step";
  static constexpr bool essential = true;
  using Reads = List<HalfStepVelocity, HalfStepThermal, Support, Acceleration, MaxSignalVelocity>;
  using Writes = List<Velocity, Thermal, Heating>;
  using Numbers = sphk::Numbers<courant_number>;
  template <class L>
  static void run(RunOf<L>& run) {
    run.limit = {};
    if (run.state.n == 0) return;
    LossCounts losses;
    Kokkos::parallel_reduce(name, Kokkos::RangePolicy<ExecutionSpace>(0, run.state.n),
                            detail::ClosingKick<L>{run.state.template as<L>()}, Kokkos::Sum<StepLimit>(run.limit),
                            Kokkos::Sum<LossCounts>(losses));
    run.counts.losses += losses;
  }
};

}  // namespace sphk
