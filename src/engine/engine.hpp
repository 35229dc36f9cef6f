#pragma once

#include <Kokkos_Core.hpp>
#include <Kokkos_Profiling_ScopedRegion.hpp>
#include <Kokkos_Timer.hpp>

#include "src/engine/diagnostics.hpp"
#include "src/engine/loading.hpp"
#include "src/engine/output.hpp"
#include "src/engine/scheme.hpp"
#include "src/engine/simulation.hpp"

namespace sphk {

/// The parts of a scheme that know its smoothing kernel and pair arithmetic.
template <class M>
class PairPasses {
 public:
  using L = typename M::Layout;
  using ApartSums = Columns<L::dimension, typename decltype(detail::apart_terms(typename M::Terms{}))::Adds>;

  bool mixed;
  double flops_per_pair;

  PairPasses(bool is_mixed, double flops) : mixed(is_mixed), flops_per_pair(flops) {}
  virtual ~PairPasses() = default;
  /// Runs the pass over pairs that has this place in a step.
  virtual void run(int place, Run<L>& run) const = 0;
  /// The sums of all terms, each apart. In double alone.
  virtual ApartSums sums_apart(const Particles<L>& particles) const = 0;
};

/// Those of scheme S.
template <class S>
class PairPassesOf final : public PairPasses<typename S::Model> {
 public:
  using Base = PairPasses<typename S::Model>;
  using typename Base::ApartSums;
  using L = typename S::Layout;
  static constexpr bool is_mixed = std::is_same_v<typename S::PairNumber, float>;

  explicit PairPassesOf(const typename S::Kernel& kernel) : Base(is_mixed, flops_per_pair<S>()), smoothing_(kernel) {}

  void run(int place, Run<L>& run) const override {
    int k = 0;
    for_each_pass(typename S::Steps{}, [&]<class P>() {
      if constexpr (over_pairs<P>)
        if (k == place) P::template run<S>(run, smoothing_);
      ++k;
    });
  }
  ApartSums sums_apart(const Particles<L>& particles) const override {
    if constexpr (is_mixed)
      throw std::logic_error("rates are computed in double: make the simulation with precision \"double\"");
    else
      return sums_of_rates(State<S>{particles, smoothing_});
  }

 private:
  SmoothingOf<S> smoothing_;
};

/// A run: the passes of a step in order, each with a timer and a profiling region.
template <class M>
class Engine final : public Simulation {
 public:
  using L = typename M::Layout;
  static constexpr int D = L::dimension;
  static constexpr int count_interval = 50;  ///< updates of each particle between two counts of true neighbours

  Engine(const ParticleSet& particles, const SimulationSettings& settings, std::unique_ptr<PairPasses<M>> pairs)
      : pairs_(std::move(pairs)),
        run_{load_run<L>(particles, settings, pairs_->mixed ? 1e-4 : 1e-7, [&](Run<L>& run) {
          pairs_->run(place_of<SmoothingLength>(typename M::Steps{}), run);
        })},
        counts_("neighbour counts", run_.state.n),
        origin_(particles.box),
        tags_(phase_tags(particles)),
        steps_accept_(pairs_->mixed ? 3e-3 : 3e-4),
        max_dt_(settings.max_dt) {
    pass_steps(typename M::Steps{});
    require_finite(run_.limit, run_.time, run_.step);
    searches_ += run_.searches;
    fits_ += run_.fits;
    seconds_.assign(seconds_.size(), 0.0);
    run_.accept = steps_accept_;
    count_neighbours(base(), counts_, report_);
  }

  StepReport step(double t_end) override {
    run_.state.clock.individual ? begin_substep(t_end) : begin_step(t_end);
    note_limiting_particle(base(), run_.limit.particle, report_);  // before the sort moves it
    ++run_.step;
    pass_steps(typename M::Steps{});
    run_.time = end_of_step_;
    require_finite(run_.limit, run_.time, run_.step);
    require_tick(run_.limit, run_.state.clock, run_.time, run_.step);
    report_.step = run_.step;
    report_.time = run_.time;
    report_.dt = run_.state.clock.dt;
    report_.updates = run_.active_count;
    updates_since_count_ += run_.active_count;
    if (updates_since_count_ >= count_interval * static_cast<long>(run_.state.n)) {
      count_neighbours(base(), counts_, report_);
      updates_since_count_ = 0;
    }
    costs_.updates += run_.active_count;
    costs_.pair_interactions += report_.mean_neighbours * static_cast<double>(run_.active_count);
    searches_ += run_.searches;
    fits_ += run_.fits;
    return report_;
  }

  double time() const override { return run_.time; }
  std::size_t size() const override { return static_cast<std::size_t>(run_.state.n); }
  StepReport last_step() const override { return report_; }
  Totals totals() const override { return sphk::totals(base()); }

  Costs costs() const override {
    Costs costs = costs_;
    costs.bytes_per_particle = bytes_per_particle<L> + (run_.state.clock.individual ? bytes_of_own_steps : 0);
    costs.flops = costs.pair_interactions * pairs_->flops_per_pair;
    std::size_t k = 0;
    for_each_pass(typename M::Steps{}, [&]<class Pass>() { costs.phases.emplace_back(Pass::name, seconds_[k++]); });
    return costs;
  }

  Snapshot snapshot() const override {
    Snapshot snapshot = take_snapshot(run_.state, origin_, run_.time, run_.step);
    if (!tags_.values.empty()) snapshot.fields.push_back(tags_);
    return snapshot;
  }

  std::vector<Field> rates(bool split) override {
    run_.state.clock.dt = 0;
    run_.accept = 1e-7;
    pass_steps(typename M::Steps{});
    run_.accept = steps_accept_;
    return rate_fields<typename M::Terms>(run_.state, pairs_->sums_apart(run_.state), split);
  }

  std::vector<std::string> warnings() const override {
    return warnings_of(searches_, fits_);
  }

 private:
  Particles<BaseLayout<L>> base() const { return run_.state.template front<BaseLayout<L>>(); }

  template <class... Pass>
  void pass_steps(Passes<Pass...> passes) {
    seconds_.resize(sizeof...(Pass));
    std::size_t k = 0;
    for_each_pass(passes, [&]<class P>() {
      Kokkos::Profiling::ScopedRegion region(P::name);
      Kokkos::Timer timer;
      if constexpr (over_pairs<P>)
        pairs_->run(static_cast<int>(k), run_);
      else
        P::run(run_);
      ExecutionSpace().fence(P::name);
      seconds_[k++] += timer.seconds();
    });
  }

  void begin_step(double t_end) {
    StepClock& clock = run_.state.clock;
    clock.dt = next_dt(t_end);
    end_of_step_ = t_end - run_.time <= clock.dt * (1 + 1e-12) ? t_end : run_.time + clock.dt;
  }

  /// Drifts to where the next steps of the hierarchy end. All particles are in step at the end of a block, which is the
  /// time asked for when the block begins.
  void begin_substep(double t_end) {
    StepClock& clock = run_.state.clock;
    const bool in_step = clock.now == 0 || clock.now == StepClock::block;
    if (!in_step && t_end != block_end_) wake_all(base());
    if (in_step || t_end != block_end_) begin_block(t_end);
    clock.next = first_end(base());
    clock.dt = static_cast<double>(clock.next - clock.now) * clock.tick;
    end_of_step_ =
        clock.next == StepClock::block ? block_end_ : block_begin_ + static_cast<double>(clock.next) * clock.tick;
  }

  void begin_block(double t_end) {
    StepClock& clock = run_.state.clock;
    block_begin_ = run_.time;
    block_end_ = t_end;
    clock.tick = (block_end_ - block_begin_) / static_cast<double>(StepClock::block);
    clock.now = clock.next = 0;
    run_.state.active.everyone = true;
    assign_steps(base(), run_.schedule, 0);
  }

  /// The limit's dt, cut to end at t_end without a sliver of a step after it.
  double next_dt(double t_end) const {
    const double limit = max_dt_ > 0 ? std::min(run_.limit.dt, max_dt_) : run_.limit.dt;
    const double left = t_end - run_.time;
    if (left <= limit) return left;
    return left < 2 * limit ? 0.5 * left : limit;
  }

  std::unique_ptr<PairPasses<M>> pairs_;
  Run<L> run_;
  CountColumns<D> counts_;
  Box origin_;
  Field tags_;  ///< they do not change, and snapshots are sorted by id too
  double steps_accept_, max_dt_;
  double end_of_step_ = 0, block_begin_ = 0, block_end_ = 0;
  long updates_since_count_ = 0;
  StepReport report_;
  Costs costs_;
  SupportCounts searches_;
  FitCounts fits_;
  std::vector<double> seconds_;
};

}  // namespace sphk
