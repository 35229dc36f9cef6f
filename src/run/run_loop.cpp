// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/run_loop.hpp"

#include <fmt/format.h>

#include "src/engine/errors.hpp"
#include "src/report/conservation.hpp"
#include "src/run/stop_signal.hpp"

namespace sphk {

namespace fs = std::filesystem;

RunLoop::RunLoop(Simulation& simulation, RunOutput& output, Checkpoints& checkpoints, Progress& progress, Plan plan,
                 const Box& box)
    : simulation_(simulation),
      output_(output),
      checkpoints_(checkpoints),
      progress_(progress),
      plan_(std::move(plan)),
      box_(box),
      state_{.begin = simulation.time()} {}

double RunLoop::output_time(long snapshot) const {
  const double part = static_cast<double>(snapshot) / static_cast<double>(plan_.snapshots);
  return snapshot == plan_.snapshots ? plan_.end : state_.begin + part * (plan_.end - state_.begin);
}

bool RunLoop::asked_to_stop() const {
  return stop_requested() || fs::exists(output_.folder() / "stop") || out_of_walltime();
}

/// Leaves time for one more step and for the checkpoint; how long that takes is known from the last one, or a snapshot.
bool RunLoop::out_of_walltime() const {
  if (plan_.walltime == 0) return false;
  const double writing = std::max(checkpoints_.seconds(), output_.seconds_per_snapshot());
  return process_.wall() + 2 * (longest_step_ + writing) > plan_.walltime;
}

void RunLoop::checkpoint() {
  checkpoints_.write(simulation_, state_, output_.state(), box_, output_.info());
  last_checkpoint_ = process_.wall();
}

void RunLoop::step(double until) {
  const Stopwatch watch;
  const std::optional<double> energy = meter_.joules();
  const StepReport report = simulation_.step(until);
  if (energy) state_.joules = state_.joules.value_or(0) + *meter_.joules() - *energy;
  state_.wall += watch.wall();
  state_.cpu += watch.cpu();
  longest_step_ = std::max(longest_step_, watch.wall());
  ++state_.steps;
  if (progress_.due()) tell(report);
  after_step_();
}

void RunLoop::tell(const StepReport& report) {
  progress_.report(report, simulation_.costs().updates, drift(output_.start(), simulation_.totals(), box_).energy);
}

void RunLoop::judge() const {
  const double energy = drift(output_.start(), simulation_.totals(), box_).energy;
  if (energy <= plan_.max_drift) return;
  throw NumericsError(fmt::format(
      "step {}, t = {:.6g}: the energy has drifted by {:.3g} of what the run began with, so that its gas is no "
      "longer that of the problem. A smaller time.courant, sph.precision = \"double\" or another scheme "
      "may keep it; time.max_drift = {:.3g} is what ends such a run",
      state_.steps, simulation_.time(), energy, plan_.max_drift));
}

/// Steps to a time, and heats on the way.
void RunLoop::go(double until) {
  for (auto& next = state_.next_heating; next < plan_.heatings.size() && plan_.heatings[next].time < until; ++next) {
    advance(plan_.heatings[next].time);
    if (stopped_ || steps_over()) return;
    simulation_.heat(plan_.heatings[next].place, plan_.heatings[next].energy);
  }
  advance(until);
}

/// Steps to a time; one that is cut short to it may miss it by round-off.
void RunLoop::advance(double until) {
  while (simulation_.time() < until - round_off() && !steps_over() && !stopped_) {
    step(until);
    stopped_ = asked_to_stop();
    const bool due = plan_.checkpoint > 0 && process_.wall() - last_checkpoint_ >= plan_.checkpoint;
    if (!stopped_ && (due || checkpoint_requested())) checkpoint();
  }
}

RunLoop::End RunLoop::run() {
  if (state_.steps == 0) output_.write(simulation_);
  for (; state_.next_snapshot <= plan_.snapshots && !steps_over(); ++state_.next_snapshot) {
    const double until = output_time(state_.next_snapshot);
    for (auto& row = state_.next_row; row < plan_.rows.size() && plan_.rows[row] < until + near(); ++row) {
      if (plan_.rows[row] > until - near()) continue;
      go(plan_.rows[row]);
      if (stopped_ || steps_over()) break;
      output_.add_row(simulation_);
      judge();
    }
    go(until);
    if (stopped_) break;
    output_.write(simulation_);
    judge();
  }
  if (state_.steps > 0) tell(simulation_.last_step());
  if (!stopped_) return End::finished;
  checkpoint();
  fs::remove(output_.folder() / "stop");
  return End::stopped;
}

}  // namespace sphk
