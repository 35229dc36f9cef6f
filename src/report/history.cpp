// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "src/engine/errors.hpp"
#include "src/report/csv.hpp"

namespace sphk {

namespace {

constexpr const char* last_standard_column = "mass_drift";

double value_of(const History::Measures& measures, const std::string& name) {
  const auto it = std::ranges::find(measures, name, &History::Measures::value_type::first);
  return it == measures.end() ? std::numeric_limits<double>::quiet_NaN() : it->second;
}

}  // namespace

History::Measures standard_columns(const StepReport& step, const Totals& t, const Conservation& drift) {
  const auto& p = t.momentum;
  const auto& l = t.angular_momentum;
  return {{"step", static_cast<double>(step.step)},
          {"time", step.time},
          {"dt", step.dt},
          {"kinetic_energy", t.kinetic},
          {"thermal_energy", t.thermal},
          {"potential_energy", t.potential},
          {"total_energy", t.energy()},
          {"momentum_x", p[0]},
          {"momentum_y", p[1]},
          {"momentum_z", p[2]},
          {"angular_momentum_x", l[0]},
          {"angular_momentum_y", l[1]},
          {"angular_momentum_z", l[2]},
          {"momentum_sizes", t.momentum_sizes},
          {"angular_momentum_sizes", t.angular_momentum_sizes},
          {"mass", t.mass},
          {"max_speed", t.max_speed},
          {"min_rho", t.min_density},
          {"max_rho", t.max_density},
          {"min_P", t.min_pressure},
          {"max_P", t.max_pressure},
          {"min_A", t.min_entropy},
          {"max_A", t.max_entropy},
          {"energy_drift", drift.energy},
          {"momentum_drift", drift.momentum},
          {"angular_momentum_drift", drift.angular_momentum},
          {last_standard_column, drift.mass}};
}

History::History(const std::filesystem::path& path) : path_(path), file_(path) {
  if (!file_)
    throw InputError(fmt::format("cannot write {}: does the folder exist, and may you write there?", path.string()));
}

History::History(const std::filesystem::path& path, std::uintmax_t bytes) : path_(path) {
  std::error_code error;
  if (std::filesystem::file_size(path, error) < bytes || error)
    throw InputError(fmt::format("{} is missing or has lost rows: without them the run cannot go on", path.string()));
  std::filesystem::resize_file(path, bytes, error);
  file_.open(path, std::ios::app);
  if (error || !file_) throw InputError(fmt::format("cannot write {}: may you write there?", path.string()));
  if (bytes == 0) return;
  const std::vector<std::string> names = read_csv(path).columns;
  measures_.assign(std::ranges::find(names, last_standard_column) + 1, names.end());
  started_ = true;
}

std::vector<HistoryRow> read_history(const std::filesystem::path& path) {
  const CsvTable table = read_csv(path);
  std::vector<HistoryRow> rows;
  for (const CsvTable::Row& line : table.rows) {
    HistoryRow& row = rows.emplace_back();
    for (std::size_t k = 0; k < std::min(table.columns.size(), line.values.size()); ++k)
      row[table.columns[k]] = std::strtod(line.values[k].c_str(), nullptr);
  }
  return rows;
}

void History::add(const StepReport& step, const Totals& totals, const Conservation& drift, const Measures& measures) {
  Measures columns = standard_columns(step, totals, drift);
  if (!started_) {
    for (const auto& [name, value] : measures) measures_.push_back(name);
    std::vector<std::string> names;
    for (const auto& [name, value] : columns) names.push_back(name);
    names.insert(names.end(), measures_.begin(), measures_.end());
    file_ << fmt::format("{}\n", fmt::join(names, ","));
    started_ = true;
  }
  std::vector<double> row;
  for (const auto& [name, value] : columns) row.push_back(value);
  for (const auto& name : measures_) row.push_back(value_of(measures, name));
  file_ << fmt::format("{:.17g}\n", fmt::join(row, ",")) << std::flush;
  if (!file_) throw InputError(fmt::format("cannot write {}: is the disk full?", path_.string()));
}

}  // namespace sphk
