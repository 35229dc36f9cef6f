// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/engine/simulation.hpp"
#include "src/io/snapshot_writer.hpp"
#include "src/report/deviations.hpp"
#include "src/report/error_budget.hpp"
#include "src/report/history.hpp"
#include "src/scenes/scene.hpp"

namespace sphk {

/// How far the output of a run has got; all else is in its history.csv.
struct OutputState {
  std::vector<double> snapshot_times;
  std::uintmax_t history_bytes = 0;
  long last_step = -1;
  double seconds = 0;
};

/// What a run writes at its output times: snapshots, their series file and the rows of history.csv.
class RunOutput {
 public:
  /// `scene` and `settings` must outlive this. Writes scene.used.toml at once; or goes on in a folder where so much as
  /// `reached` says is written already, and takes later rows back. Throws InputError where the history has been lost.
  RunOutput(const std::filesystem::path& folder, const Scene& scene, const Settings& settings,
            const OutputState* reached = nullptr);

  OutputState state() const;
  const SnapshotInfo& info() const { return info_; }

  /// Writes the next snapshot and row, unless the current step is written already. Throws InputError.
  void write(const Simulation& simulation);
  /// A row of history.csv alone.
  void add_row(const Simulation& simulation);

  /// The scene's error norms at the last output.
  const std::map<std::string, ErrorNorm>& errors() const { return errors_; }
  /// How far the scene's measures are from converged runs.
  const Deviations& deviations() const { return deviations_; }
  /// Of the kernels' sampling at the last output, where the key output.errors asks for it.
  const std::optional<ErrorBudget>& budget() const { return budget_; }
  double seconds() const { return seconds_; }
  double seconds_per_snapshot() const {
    return seconds_ / static_cast<double>(std::max<std::size_t>(series_.size(), 1));
  }
  /// The conserved sums at the first output.
  const Totals& start() const { return *start_; }
  const std::filesystem::path& folder() const { return folder_; }
  const std::string& last_snapshot() const { return series_.back().name; }

 private:
  /// With converged runs and the exact solution; what comes of it becomes columns as well.
  void compare(const Snapshot& snapshot, History::Measures& measures);
  void add_row(const Simulation& simulation, const Box& box, const History::Measures& measures);

  std::filesystem::path folder_;
  const Scene& scene_;
  const Settings& settings_;
  SnapshotInfo info_;
  Compression compression_;
  History history_;
  std::vector<SeriesEntry> series_;
  std::map<std::string, ErrorNorm> errors_;
  Deviations deviations_;
  std::optional<ErrorBudget> budget_;
  std::optional<Totals> start_;
  long last_step_ = -1;
  double seconds_ = 0;
};

/// What the files of a run say about it.
SnapshotInfo snapshot_info(const Scene& scene, const Settings& settings);

}  // namespace sphk
