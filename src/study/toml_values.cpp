// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/toml_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "src/engine/errors.hpp"

namespace sphk {

void refuse(const toml::value& value, const std::string& problem, const std::string& comment) {
  throw InputError(toml::format_error(problem, value, comment));
}

std::string text_of(const toml::value& value) {
  if (value.is_string()) return value.as_string().str;
  if (value.is_boolean()) return value.as_boolean() ? "true" : "false";
  if (value.is_integer()) return std::to_string(value.as_integer());
  if (value.is_floating()) return fmt::format("{}", value.as_floating());
  refuse(value, "not a value of a key", "one number, string, true or false is wanted here");
}

std::string string_of(const toml::value& value) {
  if (!value.is_string()) refuse(value, "not a string", "a text in quotation marks is wanted here");
  return value.as_string().str;
}

double number_of(const toml::value& value) {
  if (value.is_integer()) return static_cast<double>(value.as_integer());
  if (!value.is_floating() || std::isnan(value.as_floating())) refuse(value, "not a number", "one is wanted here");
  return value.as_floating();
}

double positive_number_of(const toml::value& value) {
  const bool number = value.is_integer() || value.is_floating();
  if (!number || !(number_of(value) > 0)) refuse(value, "not a positive number", "a number above 0 is wanted here");
  return number_of(value);
}

std::vector<std::pair<std::string, toml::value>> keys_of(const toml::value& table, const std::string& prefix) {
  if (!table.is_table()) refuse(table, "not a table", "keys are wanted here, as in a scene file");
  std::vector<std::pair<std::string, toml::value>> keys;
  for (const auto& [leaf, value] : table.as_table())
    if (value.is_table())
      std::ranges::move(keys_of(value, prefix + leaf + "."), std::back_inserter(keys));
    else
      keys.emplace_back(prefix + leaf, value);
  std::ranges::stable_sort(keys, {}, [](const auto& key) {
    const auto place = key.second.location();
    return std::pair(place.line(), place.column());
  });
  return keys;
}

std::vector<std::filesystem::path> toml_files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::ranges::sort(files, {}, &std::filesystem::path::stem);
  return files;
}

}  // namespace sphk
