// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/others.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "src/engine/errors.hpp"
#include "src/io/input_file.hpp"
#include "src/report/csv.hpp"

namespace sphk {

std::vector<OtherPoint> read_others(const std::filesystem::path& path) {
  require_file(path);
  const CsvTable table = read_csv(path);
  const std::string first_line = "the first line is: engine,setting,error,cpu_seconds,machine";
  if (table.columns.empty()) throw InputError(fmt::format("{} holds no table; {}", path.string(), first_line));
  for (const char* name : {"engine", "setting", "error", "cpu_seconds", "machine"})
    if (std::ranges::find(table.columns, name) == table.columns.end())
      throw InputError(fmt::format("{}: no column \"{}\"; {}", path.string(), name, first_line));
  std::vector<OtherPoint> points;
  for (const auto& [line, values] : table.rows) {
    const auto refuse = [&, number = line](const std::string& problem) {
      throw InputError(fmt::format("{}:{}: {}", path.string(), number, problem));
    };
    if (values.size() != table.columns.size())
      refuse(fmt::format("{} values for {} columns", values.size(), table.columns.size()));
    const auto text = [&, &row = values](const char* name) {
      return row[static_cast<std::size_t>(std::ranges::find(table.columns, name) - table.columns.begin())];
    };
    const auto positive = [&](const char* name) {
      double value = 0;
      std::istringstream(text(name)) >> value;
      if (!(value > 0) || !std::isfinite(value))
        refuse(fmt::format("{} is \"{}\", a positive number is wanted", name, text(name)));
      return value;
    };
    points.push_back({text("engine"), text("setting"), positive("error"), positive("cpu_seconds"), text("machine")});
  }
  return points;
}

}  // namespace sphk
