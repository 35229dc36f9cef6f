// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/extremes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/engine/errors.hpp"
#include "src/run/toml_file.hpp"
#include "src/study/toml_values.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

/// A case, and where its keys stand.
struct Draft {
  ExtremeCase result;
  std::vector<toml::value> places;  ///< of result.keys
  toml::value scene;
};

void set(Draft& draft, const std::string& key, const toml::value& value) {
  auto& keys = draft.result.keys;
  const auto at = std::ranges::find(keys, key, &KeyTexts::value_type::first) - keys.begin();
  if (at == std::ssize(keys)) keys.emplace_back(key, ""), draft.places.emplace_back();
  keys[at].second = text_of(value), draft.places[at] = value;
}

/// `key`: a quantity, or that with .below or .above.
void require(ExtremeCase& one, const std::string& key, const toml::value& value) {
  const auto dot = key.find('.');
  const std::string bound = dot == std::string::npos ? "" : key.substr(dot + 1);
  const bool recorded = bound.empty() && value.is_string() && value.as_string().str == "recorded";
  if (!recorded && bound != "below" && bound != "above")
    refuse(value, fmt::format("\"{}\" is no requirement", key),
           "write such as energy.below = 1e-3, nearest.above = 0.7 or wall_heating = \"recorded\"");
  const std::string quantity = key.substr(0, dot);
  auto at = std::ranges::find(one.requirements, quantity, &Requirement::quantity);
  if (at == one.requirements.end()) at = one.requirements.insert(at, Requirement{quantity});
  if (bound == "below") at->below = number_of(value);
  if (bound == "above") at->above = number_of(value);
}

std::string name_of(const toml::value& value) {
  const std::string name = string_of(value);
  const bool plain = std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) || c == '-' || c == '.'; });
  if (!plain || name.empty() || name[0] == '.')
    refuse(value, "not a name of a case", "letters, digits, - and . are wanted here: a folder gets this name");
  return name;
}

/// What a table says, over what is said above it.
void read_table(const toml::value& table, bool is_case, Draft& draft) {
  if (!table.is_table()) refuse(table, "not a case", "write [[case]], and its lines below");
  for (const auto& [name, value] : table.as_table())
    if (name == "scene")
      draft.result.scene = string_of(value), draft.scene = value;
    else if (name == "set")
      for (const auto& [key, one] : keys_of(value)) set(draft, key, one);
    else if (name == "require")
      for (const auto& [key, one] : keys_of(value)) require(draft.result, key, one);
    else if (is_case && name == "name")
      draft.result.name = name_of(value);
    else if (is_case && name == "summary")
      draft.result.summary = string_of(value);
    else if (is_case || name != "case")
      refuse(value, fmt::format("{} has no \"{}\"", is_case ? "a case" : "a file of extremes", name),
             is_case ? "it has name, summary, scene, [case.set] and [case.require]"
                     : "it has scene, [set], [require] and [[case]]");
}

/// Shows what is said against scene or keys at its place.
void run_check(const Draft& draft, const CheckKeys& check) {
  try {
    check(draft.result.scene, draft.result.keys);
  } catch (const InputError& error) {
    const std::string text = error.what(), subject = text.substr(0, text.find_first_of(" =:"));
    const auto& keys = draft.result.keys;
    const auto at = std::ranges::find(keys, subject, &KeyTexts::value_type::first) - keys.begin();
    refuse(at == std::ssize(keys) ? draft.scene : draft.places[at], text, "here");
  }
}

}  // namespace

std::string Requirement::text() const {
  std::string text = quantity;
  if (std::isfinite(below)) text += fmt::format(" < {:g}", below);
  if (std::isfinite(above)) text += fmt::format(" > {:g}", above);
  return text == quantity ? quantity + " recorded" : text;
}

std::vector<ExtremeCase> read_extremes(const fs::path& path, const CheckKeys& check) {
  const toml::value file = parse_toml(path, "file of extremes");
  Draft shared;
  read_table(file, false, shared);
  if (!file.contains("case"))
    throw InputError(fmt::format("{} has no case: write [[case]], and its lines below", path.string()));
  if (!file.at("case").is_array())
    refuse(file.at("case"), "not a list of cases", "write [[case]], with two brackets, above each");
  std::vector<ExtremeCase> cases;
  for (const toml::value& table : file.at("case").as_array()) {
    Draft draft = shared;
    read_table(table, true, draft);
    const ExtremeCase& one = draft.result;
    if (one.name.empty() || one.scene.empty())
      refuse(table, "a case without name or scene", "begin it with lines such as name = \"blast\", scene = \"tube\"");
    if (std::ranges::find(cases, one.name, &ExtremeCase::name) != cases.end())
      refuse(table.at("name"), fmt::format("a second case \"{}\"", one.name), "give it a name of its own");
    if (check) run_check(draft, check);
    cases.push_back(one);
  }
  return cases;
}

std::vector<ExtremeCase> extremes_in(const fs::path& folder, const CheckKeys& check) {
  std::vector<ExtremeCase> cases;
  for (const fs::path& file : toml_files_in(folder))
    std::ranges::move(read_extremes(file, check), std::back_inserter(cases));
  return cases;
}

}  // namespace sphk
