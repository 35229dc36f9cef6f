#include "src/report/table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/report/html.hpp"

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

std::string Table::html() const {
  std::string html = "<table>\n<thead><tr>";
  const auto add = [&](const char* tag, const std::vector<std::string>& row) {
    for (std::size_t k = 0; k < row.size(); ++k)
      html += fmt::format("<{}{}>{}</{}>", tag, std::ranges::find(words, k) != words.end() ? " class=\"words\"" : "",
                          html_text(row[k]), tag);
  };
  add("th", head);
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : rows) {
    html += "<tr>";
    add("td", row);
    html += "</tr>\n";
  }
  return html + "</tbody>\n</table>\n";
}

}  // namespace sphk
