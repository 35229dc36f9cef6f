// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/run_output.hpp"

#include <fmt/format.h>

#include <Kokkos_Core.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "kernels/core/fields.hpp"
#include "src/io/atomic_file.hpp"
#include "src/report/machine.hpp"
#include "src/run/platform.hpp"
#include "src/run/scene_file.hpp"
#include "src/run/unit_keys.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

namespace {

std::string snapshot_name(std::size_t number) {
  return fmt::format("snap_{:04}.hdf5", number);
}

/// The time that a clock which adds up steps has missed by rounding: a number of few digits that is as good as the
/// same.
double meant_time(double time) {
  const double meant = std::stod(fmt::format("{:.12g}", time));
  return std::abs(meant - time) <= 8 * std::numeric_limits<double>::epsilon() * std::abs(time) ? meant : time;
}

/// The conserved sums of a row.
Totals totals_of(const HistoryRow& row) {
  Totals totals;
  totals.mass = row.at("mass");
  totals.kinetic = row.at("kinetic_energy");
  totals.thermal = row.at("thermal_energy");
  totals.potential = row.at("potential_energy");
  for (int d = 0; d < 3; ++d) {
    totals.momentum[d] = row.at(std::string("momentum_") + "xyz"[d]);
    totals.angular_momentum[d] = row.at(std::string("angular_momentum_") + "xyz"[d]);
  }
  totals.momentum_sizes = row.at("momentum_sizes");
  totals.angular_momentum_sizes = row.at("angular_momentum_sizes");
  return totals;
}

/// Mean and largest alpha with which the viscosity acts, where the scheme has a switch.
void add_alpha(History::Measures& measures, const Snapshot& snapshot) {
  const char* const name = ViscosityAlpha::facts.name;
  if (!snapshot.has(name) || snapshot.size() == 0) return;
  const std::vector<double>& alpha = snapshot.field(name).values;
  const double sum = std::accumulate(alpha.begin(), alpha.end(), 0.0);
  measures.emplace_back("alpha_mean", sum / static_cast<double>(alpha.size()));
  measures.emplace_back("alpha_max", std::ranges::max(alpha));
}

}  // namespace

SnapshotInfo snapshot_info(const Scene& scene, const Settings& settings) {
  const SimulationSettings simulation = simulation_settings(settings);
  SnapshotInfo info;
  info.scene = scene.name();
  info.scheme = simulation.scheme;
  info.kernel = simulation.kernel;
  info.precision = simulation.precision;
  info.backend = Kokkos::DefaultExecutionSpace::name();
  info.version = build().version;
  info.git_revision = build().git_revision;
  info.scene_text = used_scene_file(settings, scene.name());
  info.neighbours = simulation.neighbours;
  info.courant = simulation.courant;
  info.units = units_of(settings);
  info.settings = settings;
  return info;
}

RunOutput::RunOutput(const std::filesystem::path& folder, const Scene& scene, const Settings& settings,
                     const OutputState* reached)
    : folder_(folder),
      scene_(scene),
      settings_(settings),
      info_(snapshot_info(scene, settings)),
      compression_(settings.text("output.compression") == "gzip" ? Compression::gzip : Compression::none),
      history_(reached ? History(folder / "history.csv", reached->history_bytes) : History(folder / "history.csv")),
      deviations_(scene.references(settings)) {
  if (!reached) {
    write_atomically(folder_ / "scene.used.toml", info_.scene_text);
    return;
  }
  last_step_ = reached->last_step;
  seconds_ = reached->seconds;
  for (const double time : reached->snapshot_times) series_.push_back({snapshot_name(series_.size()), time});
  const std::vector<HistoryRow> rows = read_history(folder_ / "history.csv");
  for (const HistoryRow& row : rows) deviations_.add(row.at("time"), {row.begin(), row.end()});
  if (!rows.empty()) start_ = totals_of(rows[0]);
}

OutputState RunOutput::state() const {
  OutputState state{{}, history_.bytes(), last_step_, seconds_};
  for (const SeriesEntry& entry : series_) state.snapshot_times.push_back(entry.time);
  return state;
}

void RunOutput::write(const Simulation& simulation) {
  const StepReport step = simulation.last_step();
  if (step.step == last_step_) return;
  const Stopwatch watch;
  Snapshot snapshot = simulation.view();
  snapshot.time = meant_time(snapshot.time);
  History::Measures measures = scene_.measures(settings_, snapshot);
  if (settings_.flag("output.errors")) {
    const std::vector<Field> errors = simulation.errors();
    budget_ = error_budget(snapshot, errors);
    snapshot.fields.insert(snapshot.fields.end(), errors.begin(), errors.end());
    for (const auto& column : columns(*budget_)) measures.push_back(column);
  }
  compare(snapshot, measures);
  const std::string name = snapshot_name(series_.size());
  const Box box = snapshot.box;
  series_.push_back({name, snapshot.time});
  write_snapshot(folder_ / name, std::move(snapshot), info_, compression_);
  write_series(folder_, series_);
  add_row(simulation, box, measures);
  last_step_ = step.step;
  seconds_ += watch.wall();
}

void RunOutput::add_row(const Simulation& simulation) {
  const Stopwatch watch;
  const Snapshot snapshot = simulation.view();
  History::Measures measures = scene_.measures(settings_, snapshot);
  compare(snapshot, measures);
  add_row(simulation, snapshot.box, measures);
  seconds_ += watch.wall();
}

void RunOutput::compare(const Snapshot& snapshot, History::Measures& measures) {
  snapshot.let_go();
  deviations_.add(snapshot.time, measures);
  errors_ = scene_.errors(settings_, snapshot);
  snapshot.let_go();
  for (const auto& [field, norm] : errors_) measures.emplace_back("l1_" + field, norm.l1);
  add_alpha(measures, snapshot);
  snapshot.let_go();
}

void RunOutput::add_row(const Simulation& simulation, const Box& box, const History::Measures& measures) {
  const Totals totals = simulation.totals();
  if (!start_) start_ = totals;
  history_.add(simulation.last_step(), totals, drift(*start_, totals, box), measures);
}

}  // namespace sphk
