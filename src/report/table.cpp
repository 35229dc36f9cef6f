// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace sphk {

std::string Table::text() const {
  const auto is_words = [this](std::size_t k) { return std::ranges::find(words, k) != words.end(); };
  std::vector<std::size_t> widths;
  for (const std::string& word : head) widths.push_back(word.size());
  for (const auto& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  std::string text;
  const auto add = [&](const std::vector<std::string>& row) {
    for (std::size_t k = 0; k < row.size(); ++k)
      text += is_words(k) ? fmt::format("  {:<{}}", row[k], widths[k]) : fmt::format("  {:>{}}", row[k], widths[k]);
    text.erase(text.find_last_not_of(' ') + 1);
    text += "\n";
  };
  add(head);
  for (const auto& row : rows) add(row);
  return text;
}

}  // namespace sphk
