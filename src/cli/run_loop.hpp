#pragma once

#include "src/cli/run_output.hpp"
#include "src/report/energy_meter.hpp"
#include "src/report/progress.hpp"

namespace sphk {

/// The time loop of a run: from output time to output time, with reports in between.
class RunLoop {
 public:
  enum class End { finished, stopped };

  struct Plan {
    double end = 1;              ///< code units
    long steps = 0;              ///< stop after so many; 0: no limit
    long snapshots = 1;          ///< after the first, at equal intervals of time
    std::vector<double> rows{};  ///< times of further rows of history.csv, rising
  };

  RunLoop(Simulation& simulation, RunOutput& output, Progress& progress, Plan plan, const Box& box);

  /// Writes the first output, runs to the end of the plan or to the first SIGTERM or SIGINT, and writes the state it
  /// stops at. Throws NumericsError and InputError; steps(), wall() and cpu() hold what was done until then.
  End run();

  long steps() const { return steps_; }
  /// Wall-clock and CPU seconds of the steps alone.
  double wall() const { return wall_; }
  double cpu() const { return cpu_; }
  /// Energy of the processors during the steps, in J, where the machine tells.
  std::optional<double> joules() const { return joules_; }

 private:
  double output_time(long snapshot) const;
  /// Times closer than these are the same: for the end of a step, for an output.
  double round_off() const { return 1e-12 * (plan_.end - begin_); }
  double near() const { return 1e-6 * (plan_.end - begin_); }
  bool over() const;
  void go(double until);
  void step(double until);
  void tell(const StepReport& report);

  Simulation& simulation_;
  RunOutput& output_;
  Progress& progress_;
  Plan plan_;
  Box box_;
  double begin_;
  long steps_ = 0;
  double wall_ = 0, cpu_ = 0;
  EnergyMeter meter_;
  std::optional<double> joules_;
};

}  // namespace sphk
