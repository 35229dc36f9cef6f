// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/convergence_switch.hpp"
#include "kernels/passes/kick_drift.hpp"
#include "kernels/passes/mass_exchange.hpp"
#include "kernels/passes/rates.hpp"
#include "kernels/passes/run.hpp"

namespace sphk {

// What many schemes share is compiled apart from them: the templates below know the first fields of a layout alone.

/// Steps between two sorts; with steps of the particles' own, updates of each.
inline constexpr int sort_interval = 10;

/// Whether the particles are to be sorted: every sort_interval steps, and when one strays half a period out of a
/// periodic box. The cells must be fitted. This and the two that follow: defined in sorted_cells.hpp.
template <class L>
bool is_sort_due(const Particles<L>& state, const Schedule& schedule, long step);

/// Sorts the particles in space again, wraps them into a periodic box and fits the boxes of the cells, which must be
/// fitted before as well.
template <class L>
void sort_cells(Particles<L>& state, Sorter<L::dimension>& sorter, Schedule& schedule);

/// Fits the boxes of some cells to positions and supports, and those of the nodes above.
template <class L>
void fit_cells(const Particles<L>& state, const ParticleSubset& cells);

/// Marks the particles whose steps end now, by cells, and the cells near them, and counts them. This and the following:
/// in schedule.hpp.
template <class L>
long mark_active(Particles<L>& state, Schedule& schedule);

/// Gives the active particles steps that begin at `start`, and keeps neighbours within a factor 4 of each other.
template <class L>
void assign_steps(const Particles<L>& state, const Schedule& schedule, Ticks start);

/// Brings all particles in step in the midst of a block; a new block may begin.
template <class L>
void wake_all(const Particles<L>& state);

/// The tick at which the next steps end.
template <class L>
Ticks first_end(const Particles<L>& state, const Schedule& schedule);

/// Learns the ranges of steps anew, after particles or their steps have changed elsewhere than here.
template <class L>
void fit_ranges(const Particles<L>& state, const Schedule& schedule);

/// Support radii, n and rho of the active particles by Newton's method from the present h (S12 eq 6, 11), then the
/// scheme's further sums at the final h. A search ends when its step is below accept * h; n and rho are then carried
/// over to first order. Defined in smoothing_length.hpp.
template <class S>
SupportCounts find_support(const State<S>& state, const Given& given, double accept);

/// div v, curl v and grad(div v) from second-order polynomials fitted to the velocities of the neighbours with weights
/// m_j Wbar (S12 eq 26-28, App. D); linear fits, then the standard SPH estimate, where neighbours are degenerate.
/// Defined in gradients.hpp.
template <class S>
FitCounts fit_velocities(const State<S>& state);

/// Whether these two loops are compiled apart from the schemes that have core S, once for all of them: such schemes
/// call the following, which do the same. Host code says which (src/schemes/shared_loops.hpp).
template <class S>
inline constexpr bool compiled_apart = false;
template <class S>
SupportCounts find_support_apart(const State<S>& state, const Given& given, double accept);
template <class S>
FitCounts fit_velocities_apart(const State<S>& state);

/// Boxes of the cells; now and then the order of the particles in space.
struct SortedCells {
  static constexpr const char* name = "cells";
  static constexpr bool essential = true;
  using Reads = List<Position, Support>;
  using Writes = List<>;
  template <class L>
  static void run(RunOf<L>& run) {
    fit_cells(run.state, {});
    if (!is_sort_due(run.state, run.schedule, run.step)) return;
    predict<L>(run, {});
    sort_cells(run.state, run.sorter, run.schedule);
  }
};

/// The particles whose steps end now, and what their pairs read of those whose steps do not.
struct ActiveParticles {
  static constexpr const char* name = "active particles";
  static constexpr bool essential = true;
  using Reads = List<Position, Support>;
  using Writes = List<>;
  template <class L>
  static void run(RunOf<L>& run) {
    run.active_count = mark_active(run.state, run.schedule);
    run.schedule.updates_since_sort += static_cast<double>(run.active_count);
    predict<L>(run, run.schedule.near);
  }
};

/// Support radii and the gather sums; the cells learn the new radii.
struct SmoothingLength {
  static constexpr const char* name = "smoothing length and density";
  static constexpr bool over_pairs = true, essential = true;
  template <class R>
  using ReadsIn = Union<List<Position, Mass, Support>, typename R::DensityTerms::Reads>;
  template <class R>
  using WritesIn = Union<List<Support, InverseSupport, NumberDensity, NumberDensitySlope, Density, DensitySlope>,
                         typename R::DensityTerms::Adds>;
  using Numbers = sphk::Numbers<neighbour_number, largest_support>;
  template <class S>
  static void run(RunOf<typename S::Layout>& run, const SmoothingOf<S>& smoothing) {
    using Core = typename S::Core;
    const State<Core> state{run.state.template as<typename Core::Layout>(), smoothing};
    if constexpr (compiled_apart<Core>)
      run.counts.searches = find_support_apart(state, run.given, run.accept);
    else
      run.counts.searches = find_support(state, run.given, run.accept);
    fit_cells(run.state, run.schedule.near);
  }
};

/// Fitted gradients of the velocity.
struct Gradients {
  static constexpr const char* name = "gradients";
  static constexpr bool over_pairs = true;
  using Reads = List<Position, Support, InverseSupport, Mass, Velocity, Density>;
  using Writes = List<VelocityDivergence, VelocityCurl, GradVelocityDivergence>;
  using Keeps = Writes;
  template <class S>
  static void run(RunOf<typename S::Layout>& run, const SmoothingOf<S>& smoothing) {
    using Core = typename S::Core;
    const State<Core> state{run.state.template as<typename Core::Layout>(), smoothing};
    if constexpr (compiled_apart<Core>)
      run.counts.fits = fit_velocities_apart(state);
    else
      run.counts.fits = fit_velocities(state);
  }
};

/// All terms in one loop over pairs.
struct Rates {
  static constexpr const char* name = "rates";
  static constexpr bool over_pairs = true, essential = true;
  template <class R>
  using ReadsIn = typename R::RateTerms::Reads;
  template <class R>
  using WritesIn = typename R::RateTerms::Adds;
  template <class S>
  static void run(RunOf<typename S::Layout>& run, const SmoothingOf<S>& smoothing) {
    const State<S> state{run.state.template as<typename S::Layout>(), smoothing};
    add_pair_sums(name, state, typename S::RateTerms(run.given), state.columns);
  }
};

/// The next steps of the active particles (S12 sec 5; Saitoh & Makino 2009), where particles have steps of their own.
struct NextSteps {
  static constexpr const char* name = "next steps";
  static constexpr bool essential = true;
  using Reads = List<Support, MaxSignalVelocity>;
  using Writes = List<>;
  template <class L>
  static void run(RunOf<L>& run) {
    StepClock& clock = run.state.clock;
    if (!clock.individual) return;
    clock.now = clock.next;
    if (clock.now > 0 && clock.now < StepClock::block) assign_steps(run.state, run.schedule, clock.now);
  }
};

}  // namespace sphk
