// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "src/report/conservation.hpp"

namespace sphk {

/// history.csv: one row an output time. The first row fixes the columns: the standard ones, then the measures' names.
class History {
 public:
  using Measures = std::vector<std::pair<std::string, double>>;

  /// Opens (and empties) `path`; throws InputError where that fails.
  explicit History(const std::filesystem::path& path);
  /// Goes on after the first `bytes` of it. Throws InputError where it has not so many.
  History(const std::filesystem::path& path, std::uintmax_t bytes);
  /// Appends a row and flushes it. A measure that the first row did not have is left out; one it had and this row has
  /// not is "nan".
  void add(const StepReport& step, const Totals& totals, const Conservation& drift, const Measures& measures);
  std::uintmax_t bytes() const { return std::filesystem::file_size(path_); }

 private:
  std::filesystem::path path_;
  std::ofstream file_;
  std::vector<std::string> measures_;
  bool started_ = false;
};

/// The standard columns of a row, in the file's order.
History::Measures standard_columns(const StepReport& step, const Totals& totals, const Conservation& drift);

/// A row of a history, by column.
using HistoryRow = std::map<std::string, double>;
/// The rows that are there; numbers come back as they were written, bit by bit. Throws InputError where there is no
/// file.
std::vector<HistoryRow> read_history(const std::filesystem::path& path);

}  // namespace sphk
