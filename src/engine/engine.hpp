// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <Kokkos_Profiling_ScopedRegion.hpp>
#include <Kokkos_Timer.hpp>
#include <tuple>

#include "src/engine/archive.hpp"
#include "src/engine/gains.hpp"
#include "src/engine/heating.hpp"
#include "src/engine/held.hpp"
#include "src/engine/load_run.hpp"
#include "src/engine/neighbour_counts.hpp"
#include "src/engine/output.hpp"
#include "src/engine/predicted_rows.hpp"
#include "src/engine/snapshot.hpp"
#include "src/engine/step_errors.hpp"
#include "src/engine/totals.hpp"

namespace sphk {

/// A run: the passes of a step in order, each with a timer and a profiling region.
template <class L>
class Engine final : public Simulation {
 public:
  static constexpr int D = L::dimension;
  static constexpr int count_interval = 50;  ///< updates of each particle between two counts of true neighbours

  Engine(const ParticleSet& particles, const SimulationSettings& settings, std::unique_ptr<SchemePasses<L>> passes)
      : passes_(std::move(passes)),
        facts_(passes_->facts),
        run_(load_run<L>(particles, settings, facts_, [&](Run<L>& run) { passes_->run(facts_.support_pass, run); })),
        origin_(particles.box),
        tags_(tags_by_id(particles)),
        steps_accept_(facts_.mixed ? 3e-3 : 3e-4),
        max_dt_(settings.max_dt),
        seconds_(facts_.passes.size()) {
    for (std::size_t k = 0; k < facts_.passes.size(); ++k)
      if (facts_.passes[k].wanted(run_.given)) wanted_.push_back(k);
    if (facts_.density_pass != facts_.support_pass)
      settle_at(energies_at(run_, component_offset<D, Density, typename L::Fields>));
    run_passes();
    require_finite();
    counted_ += run_.counts;
    seconds_.assign(seconds_.size(), 0.0);
    run_.accept = steps_accept_;
    count_neighbours(run_, report_);
  }

  StepReport step(double t_end) override {
    run_.state.clock.individual ? begin_substep(t_end) : begin_step(t_end);
    note_limiting_particle(run_.state, run_.limit.particle, report_);  // before the sort moves it
    ++run_.step;
    run_passes();
    run_.time = end_of_step_;
    require_finite();
    if (run_.state.clock.individual) require_tick();
    report_.step = run_.step;
    report_.time = run_.time;
    report_.dt = run_.state.clock.dt;
    report_.updates = run_.active_count;
    updates_since_count_ += run_.active_count;
    if (updates_since_count_ >= count_interval * static_cast<long>(run_.state.n)) {
      count_neighbours(run_, report_);
      updates_since_count_ = 0;
    }
    costs_.updates += run_.active_count;
    costs_.pair_interactions += report_.mean_neighbours * static_cast<double>(run_.active_count);
    counted_ += run_.counts;
    return report_;
  }

  void heat(const Array3& place, double energy) override {
    const Energies u = end_all_steps();
    heat_nearest(run_.state, u, place, energy);
    heated_ += energy;
    begin_all_steps(u);
  }

  void add(const Gains& gains) override {
    const Energies u = end_all_steps();
    const double before = totals().energy();
    add_gains(run_.state, u, gains);
    begin_all_steps(u);
    heated_ += totals().energy() - before;
  }

  double time() const override { return run_.time; }
  std::size_t size() const override { return static_cast<std::size_t>(run_.state.n); }
  StepReport last_step() const override { return report_; }
  Totals totals() const override {
    Totals totals = sphk::totals(run_.state);
    totals.heated = heated_;
    return totals;
  }

  Costs costs() const override {
    Costs costs = costs_;
    costs.bytes_per_particle = facts_.bytes_per_particle + (run_.state.clock.individual ? bytes_of_own_steps : 0);
    costs.flops = costs.pair_interactions * facts_.flops_per_pair;
    for (const std::size_t k : wanted_) costs.phases.emplace_back(facts_.passes[k].name, seconds_[k]);
    return costs;
  }

  Snapshot view() const override {
    const bool whole = all_in_step();
    Snapshot view = look_at_all([&] {
      Snapshot made = view_of(run_.state, facts_, origin_, run_.time, run_.step);
      for (Field& field : made.fields)
        if (!whole) field.make = [values = field.make()] { return values; };
      return made;
    });
    if (!tags_.empty()) {
      view.fields.push_back(phase_tags({}));
      view.fields.back().make = [this] { return std::vector<double>(tags_.begin(), tags_.end()); };
    }
    return view;
  }

  HeldParticles held() const override {
    return all_in_step() ? held_in(run_.state, facts_) : HeldParticles{ids_of(run_.state), {}, {}};
  }

  std::vector<Field> rates(bool split) override {
    run_.state.clock.dt = 0;
    run_.accept = 1e-7;
    run_passes();
    run_.accept = steps_accept_;
    return passes_->rates(run_, split);
  }

  std::vector<Field> errors() const override {
    return look_at_all([&] { return passes_->errors(run_.state); });
  }

  void save(const TakeBlock& take) const override {
    StateWriter writer(take);
    exchange(*this, writer);
  }

  void restore(const GiveBlock& give) override {
    StateReader reader(give);
    exchange(*this, reader);
    if (run_.state.clock.individual) fit_ranges(run_.state, run_.schedule);
  }

  Counts counts() const override { return counts_of(counted_); }

 private:
  /// Hands everything that changes in a run, but for what each step computes anew, to a writer or reader.
  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    auto& run = self.run_;
    const auto stride = static_cast<std::size_t>(run.state.columns.stride);
    for (std::size_t row = 0; row < static_cast<std::size_t>(self.facts_.rows); ++row) {
      auto numbers = Kokkos::subview(run.state.columns.data, std::pair(row * stride, (row + 1) * stride));
      archive("row " + std::to_string(row), numbers);  // one by one: what is written can be let go of
    }
    archive("ids", run.state.ids);
    archive("nodes", run.state.tree.nodes());
    archive("tags", self.tags_);
    archive("time", run.time);
    archive("step", run.step);
    archive("active_count", run.active_count);
    archive("limit", run.limit);
    auto& clock = run.state.clock;
    archive("dt", clock.dt);
    archive("tick", clock.tick);
    archive("now", clock.now);
    archive("next", clock.next);
    archive("everyone_active", run.state.active.everyone);
    archive("starting", run.schedule.starting);
    archive("updates_since_sort", run.schedule.updates_since_sort);
    if (clock.individual) {
      archive("begins", clock.begin);
      archive("ends", clock.end);
      archive("powers", clock.power);
      archive("late", clock.late);
      archive("active_masks", run.state.active.masks);
    }
    archive("start", self.start_);
    archive("heated", self.heated_);
    archive("end_of_step", self.end_of_step_);
    archive("block_begin", self.block_begin_);
    archive("block_end", self.block_end_);
    archive("report", self.report_);
    archive("updates_since_count", self.updates_since_count_);
    archive("updates", self.costs_.updates);
    archive("pair_interactions", self.costs_.pair_interactions);
    archive("seconds", self.seconds_);
    archive("counts", self.counted_);
  }

  void run_passes() {
    for (const std::size_t k : wanted_) {
      Kokkos::Profiling::ScopedRegion region(facts_.passes[k].name);
      Kokkos::Timer timer;
      passes_->run(static_cast<int>(k), run_);
      ExecutionSpace().fence(facts_.passes[k].name);
      seconds_[k] += timer.seconds();
    }
  }

  void settle_at(const Energies& u) {
    take_energies(run_.state, u, [&] { passes_->run(facts_.density_pass, run_); });
  }

  /// All particles at the present time, and their specific energies.
  Energies end_all_steps() {
    StepClock& clock = run_.state.clock;
    if (clock.individual) {
      if (!all_in_step()) wake_all(run_.state);
      clock.now = clock.next = 0;
      Kokkos::deep_copy(ExecutionSpace(), clock.begin, 0);
      Kokkos::deep_copy(ExecutionSpace(), clock.end, 0);
      fit_ranges(run_.state, run_.schedule);
    }
    passes_->predict(run_);
    clock.dt = 0;
    run_.state.active.everyone = true;
    return energies_at(run_, run_.state.state_density_row);
  }

  /// Goes on with these energies and the shortest step that any particle asks for.
  void begin_all_steps(const Energies& u) {
    settle_at(u);
    run_passes();
    require_finite();
    start_ = run_.time;
  }

  bool all_in_step() const {
    const StepClock& clock = run_.state.clock;
    return !clock.individual || clock.now == 0 || clock.now == StepClock::block;
  }

  /// What look() sees of all particles at the present time. Where some sleep they are predicted for as long as that
  /// takes: a run goes on in the same way whoever looks at it.
  template <class Look>
  auto look_at_all(const Look& look) const {
    if (all_in_step()) return look();
    const Particles<L>& state = run_.state;
    const std::vector<int> rows = predicted_rows(facts_.fields);
    const auto stride = static_cast<std::size_t>(state.columns.stride);
    const ColumnNumbers kept("rows, before a look", rows.size() * stride);
    const Kokkos::View<double*, MemorySpace> late("late cells, before a look", state.clock.late.extent(0));
    const auto copy = [](const auto& to, const auto& from) { Kokkos::deep_copy(ExecutionSpace(), to, from); };
    const auto each_row = [&](const auto& copy_row) {
      for (std::size_t k = 0; k < rows.size(); ++k)
        copy_row(rows_of(state, rows[k], 1), Kokkos::subview(kept, std::pair(k * stride, (k + 1) * stride)));
    };
    each_row([&](const auto& row, const auto& spare) { copy(spare, row); });
    copy(late, state.clock.late);
    passes_->predict(run_);
    auto seen = look();
    each_row([&](const auto& row, const auto& spare) { copy(row, spare); });
    copy(state.clock.late, late);
    return seen;
  }

  void begin_step(double t_end) {
    StepClock& clock = run_.state.clock;
    clock.dt = next_dt(t_end);
    if (!(run_.time + clock.dt > run_.time)) throw StuckError(StuckReason::no_progress, stuck_particle());
    end_of_step_ = t_end - run_.time <= clock.dt * (1 + 1e-12) ? t_end : run_.time + clock.dt;
  }

  /// Drifts to where the next steps of the hierarchy end. All particles are in step at the end of a block, which is the
  /// time asked for when the block begins.
  void begin_substep(double t_end) {
    StepClock& clock = run_.state.clock;
    const bool in_step = all_in_step();
    if (!in_step && t_end != block_end_) wake_all(run_.state);
    if (in_step || t_end != block_end_) begin_block(t_end);
    clock.next = first_end(run_.state, run_.schedule);
    clock.dt = static_cast<double>(clock.next - clock.now) * clock.tick;
    end_of_step_ =
        clock.next == StepClock::block ? block_end_ : block_begin_ + static_cast<double>(clock.next) * clock.tick;
  }

  void begin_block(double t_end) {
    StepClock& clock = run_.state.clock;
    block_begin_ = run_.time;
    block_end_ = t_end;
    clock.tick = (block_end_ - block_begin_) / static_cast<double>(StepClock::block);
    require_tick();
    clock.now = clock.next = 0;
    run_.state.active.everyone = true;
    // Dissipation sets in with the first step. On unlike steps the two sides of a pair would feel that for unlike
    // times.
    run_.schedule.starting = run_.schedule.limiter && run_.time == start_;
    assign_steps(run_.state, run_.schedule, 0);
  }

  void require_finite() const {
    if (!(run_.limit.dt > 0)) throw StuckError(StuckReason::not_finite, stuck_particle());
  }
  void require_tick() const {
    const double tick = run_.state.clock.tick;
    if (!(run_.limit.dt >= tick)) throw StuckError(StuckReason::below_the_ticks, stuck_particle());
  }
  StuckParticle stuck_particle() const {
    StepReport report;
    note_limiting_particle(run_.state, run_.limit.particle, report);
    return {report.limiting_id, report.limiting_x, run_.time, run_.step, run_.limit.dt, run_.state.clock.tick};
  }

  /// The limit's dt, cut to end at t_end without a sliver of a step after it.
  double next_dt(double t_end) const {
    const double limit = max_dt_ > 0 ? std::min(run_.limit.dt, max_dt_) : run_.limit.dt;
    const double left = t_end - run_.time;
    if (left <= limit) return left;
    return left < 2 * limit ? 0.5 * left : limit;
  }

  std::unique_ptr<SchemePasses<L>> passes_;
  const CompiledFacts& facts_;
  Run<L> run_;
  Box origin_;
  std::vector<int> tags_;  ///< by id, as snapshots are sorted
  double steps_accept_, max_dt_;
  double heated_ = 0;
  double start_ = run_.time;  ///< when all particles last began with one step
  double end_of_step_ = 0, block_begin_ = 0, block_end_ = 0;
  long updates_since_count_ = 0;
  std::vector<std::size_t> wanted_;  ///< passes that this run has, by their place in a step
  std::vector<double> seconds_;      ///< of all passes
  StepReport report_;
  Costs costs_;
  StepCounts counted_;
};

template <class L>
std::unique_ptr<Simulation> make_run(const ParticleSet& particles, const SimulationSettings& settings,
                                     std::unique_ptr<SchemePasses<L>> passes) {
  return std::make_unique<Engine<L>>(particles, settings, std::move(passes));
}

/// All that is compiled of a run for base layout L, passes included.
template <class L>
constexpr auto compiled_run() {
  return std::tuple{&make_run<L>,    &load_run<L>,    &sort_cells<L>,   &fit_cells<L>,
                    &mark_active<L>, &is_sort_due<L>, &assign_steps<L>, &wake_all<L>,
                    &first_end<L>,   &fit_ranges<L>,  &fill_row<L>,     &pull_to_centre<L>};
}

}  // namespace sphk
