#include "src/cli/run_loop.hpp"

#include "src/cli/stop_signal.hpp"
#include "src/report/conservation.hpp"
#include "src/report/machine.hpp"

namespace sphk {

RunLoop::RunLoop(Simulation& simulation, RunOutput& output, Progress& progress, Plan plan, const Box& box)
    : simulation_(simulation),
      output_(output),
      progress_(progress),
      plan_(plan),
      box_(box),
      begin_(simulation.time()) {}

double RunLoop::output_time(long snapshot) const {
  const double part = static_cast<double>(snapshot) / static_cast<double>(plan_.snapshots);
  return snapshot == plan_.snapshots ? plan_.end : begin_ + part * (plan_.end - begin_);
}

bool RunLoop::over() const {
  return stop_requested() || (plan_.steps > 0 && steps_ >= plan_.steps);
}

void RunLoop::step(double until) {
  const Stopwatch watch;
  const std::optional<double> energy = meter_.joules();
  const StepReport report = simulation_.step(until);
  if (energy) joules_ = joules_.value_or(0) + *meter_.joules() - *energy;
  wall_ += watch.wall();
  cpu_ += watch.cpu();
  ++steps_;
  if (progress_.due()) tell(report);
}

void RunLoop::tell(const StepReport& report) {
  progress_.report(report, simulation_.costs().updates, drift(output_.start(), simulation_.totals(), box_).energy);
}

/// Steps to a time; one that is cut short to it may miss it by round-off.
void RunLoop::go(double until) {
  while (simulation_.time() < until - round_off() && !over()) step(until);
}

RunLoop::End RunLoop::run() {
  output_.write(simulation_);
  auto row = plan_.rows.begin();
  for (long snapshot = 1; snapshot <= plan_.snapshots && !over(); ++snapshot) {
    const double until = output_time(snapshot);
    for (; row != plan_.rows.end() && *row < until + near(); ++row) {
      if (*row > until - near()) continue;
      go(*row);
      if (!over()) output_.add_row(simulation_);
    }
    go(until);
    output_.write(simulation_);
  }
  if (steps_ > 0) tell(simulation_.last_step());
  const bool complete = simulation_.time() >= plan_.end - round_off() || (plan_.steps > 0 && steps_ >= plan_.steps);
  return complete ? End::finished : End::stopped;
}

}  // namespace sphk
