// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "src/report/machine.hpp"
#include "src/run/run.hpp"
#include "src/run/run_folder.hpp"

namespace sphk::python {

/// An array of n rows of `components` numbers, or of n numbers, in the run's own order: its memory, or numbers of its
/// own.
struct FieldArray {
  const double* data = nullptr;
  std::size_t n = 0, components = 1, row_stride = 1, component_stride = 1;
  bool rows = false;
  std::shared_ptr<const void> memory;
};

/// A simulation with its problem, the rows of its history, and the folders that it is saved in.
class LiveRun {
 public:
  /// `given_units`: it computes in the user's units, not in those that suit the gas, so that arrays are views.
  LiveRun(Problem problem, const ParticleSet& gas, bool given_units);

  /// One step, which does not pass `until`.
  StepReport step(double until);
  /// Writes a row of the history, unless the state has one.
  void note();
  /// A row is due: every particle has been computed since the last one.
  bool note_due() const { return updates_ >= simulation().size(); }
  const std::vector<History::Measures>& history() const { return history_; }

  /// The simulation. Throws InputError once the run is closed.
  Simulation& simulation() const;
  void close() { folders_.clear(), simulation_.reset(); }

  const Problem& problem() const { return problem_; }
  SimulationSettings method() const;
  const RunRecord& record() const { return record_; }
  const Box& box() const { return box_; }
  int dimension() const { return record_.dimension; }

  /// Names of the fields, and one of them. Throws InputError with the names that there are.
  std::vector<std::string> fields() const;
  FieldArray field(const std::string& name) const;
  /// Fields that are sorted by id, in the run's order and its dimensions.
  std::map<std::string, FieldArray> in_own_order(std::vector<Field> fields) const;

  /// Writes a snapshot, and what `sphk run` leaves beside it, into a folder of this run; the next call adds another.
  std::filesystem::path save(const std::filesystem::path& folder, bool overwrite);

 private:
  struct Folder;
  bool is_vector(const std::string& name) const;
  FieldArray array_of(const Field& field, const std::vector<std::uint64_t>& ids) const;

  Problem problem_;
  bool given_units_;
  RunRecord record_;
  Box box_;
  std::unique_ptr<Simulation> simulation_;
  LoopState done_;
  Totals start_;
  std::vector<History::Measures> history_;
  std::size_t updates_ = 0;  ///< since the last row
  std::optional<double> noted_;
  std::map<std::filesystem::path, std::shared_ptr<Folder>> folders_;
};

}  // namespace sphk::python
