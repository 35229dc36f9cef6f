// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <string_view>

#include "src/engine/errors.hpp"

namespace sphk {

namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::vector<std::string> values_of(std::string_view line) {
  std::vector<std::string> values(1);
  bool quoted = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const bool mark = line[k] == '"', doubled = mark && quoted && line.substr(k + 1).starts_with('"');
    if (line[k] == ',' && !quoted)
      values.emplace_back();
    else if (!mark || doubled)
      values.back() += line[k];
    else
      quoted = !quoted;
    k += doubled;
  }
  std::ranges::transform(values, values.begin(), trimmed);
  return values;
}

}  // namespace

CsvTable read_csv(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw InputError(fmt::format("cannot read {}: is the path right?", path.string()));
  CsvTable table;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (trimmed(line).empty() || line[0] == '#') continue;
    if (table.columns.empty())
      table.columns = values_of(line);
    else
      table.rows.push_back({number, values_of(line)});
  }
  return table;
}

std::string csv_line(const std::vector<std::string>& values) {
  std::vector<std::string> words = values;
  for (std::string& word : words) {
    std::ranges::replace(word, '\n', ' ');
    if (word.find_first_of(",\"#") == std::string::npos) continue;
    for (std::size_t k = 0; (k = word.find('"', k)) != std::string::npos; k += 2) word.insert(k, 1, '"');
    word = '"' + word + '"';
  }
  return fmt::format("{}\n", fmt::join(words, ","));
}

}  // namespace sphk
