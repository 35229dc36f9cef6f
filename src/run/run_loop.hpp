// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "src/report/energy_meter.hpp"
#include "src/report/machine.hpp"
#include "src/report/progress.hpp"
#include "src/run/checkpoints.hpp"
#include "src/run/run_output.hpp"

namespace sphk {

/// The time loop of a run: from output time to output time, with reports in between.
class RunLoop {
 public:
  enum class End { finished, stopped };

  struct Plan {
    double end = 1;                     ///< code units
    long steps = 0;                     ///< stop after so many; 0: no limit
    long snapshots = 1;                 ///< after the first, at equal intervals of time
    std::vector<double> rows{};         ///< times of further rows of history.csv, rising
    std::vector<HeatEvent> heatings{};  ///< in the order of their times
    double checkpoint = 0;              ///< wall-clock seconds between checkpoints; 0: when it stops alone
    double walltime = 0;                ///< wall-clock seconds of this process; 0: no limit
    double max_drift = 1;               ///< of the energy (conservation.hpp): beyond it the run has failed
  };

  RunLoop(Simulation& simulation, RunOutput& output, Checkpoints& checkpoints, Progress& progress, Plan plan,
          const Box& box);
  /// What is called after every step.
  void each_step(std::function<void()> act) { after_step_ = std::move(act); }
  /// Where a saved run had got.
  void resume(const LoopState& state) { state_ = state; }

  /// Writes the first output and runs to the end of the plan; or until a signal (stop_signal.hpp), a file "stop" in the
  /// run's folder or the plan's wall-clock time stops it, and then leaves a checkpoint. Throws NumericsError and
  /// InputError; state() holds what was done until then.
  End run();

  const LoopState& state() const { return state_; }

 private:
  double output_time(long snapshot) const;
  /// Times closer than these are the same: for the end of a step, for an output.
  double round_off() const { return 1e-12 * (plan_.end - state_.begin); }
  double near() const { return 1e-6 * (plan_.end - state_.begin); }
  bool steps_over() const { return plan_.steps > 0 && state_.steps >= plan_.steps; }
  bool asked_to_stop() const;
  bool out_of_walltime() const;
  void checkpoint();
  void go(double until);
  void advance(double until);
  void step(double until);
  void tell(const StepReport& report);
  /// Throws NumericsError where the energy at an output has drifted too far.
  void judge() const;

  Simulation& simulation_;
  RunOutput& output_;
  Checkpoints& checkpoints_;
  Progress& progress_;
  Plan plan_;
  Box box_;
  LoopState state_;
  std::function<void()> after_step_ = [] {};
  EnergyMeter meter_;
  Stopwatch process_;
  double longest_step_ = 0, last_checkpoint_ = 0;  ///< wall-clock seconds
  bool stopped_ = false;
};

}  // namespace sphk
