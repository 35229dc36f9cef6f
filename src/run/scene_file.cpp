// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/engine/errors.hpp"
#include "src/engine/hint.hpp"
#include "src/run/toml_file.hpp"
#include "src/run/unit_keys.hpp"

namespace sphk {

namespace {

bool is_scene_name(const std::string& name) {
  return name == "scene" || name == "scene.name";
}

/// Where the key stands in its line: the last occurrence of its name before the value, or the first in [section].
int key_column(const std::string& line, const std::string& leaf, int value_column) {
  auto at = line.rfind(leaf, static_cast<std::size_t>(value_column - 1));
  if (at == std::string::npos) at = line.find(leaf);
  return at == std::string::npos ? value_column : static_cast<int>(at) + 1;
}

SceneFileEntry entry_of(const std::string& name, const std::string& leaf, const toml::value& value) {
  const auto place = value.location();
  SceneFileEntry entry;
  entry.name = name;
  entry.line = static_cast<int>(place.line());
  entry.value_column = static_cast<int>(place.column());
  entry.key_column = key_column(place.line_str(), leaf, entry.value_column);
  entry.line_text = place.line_str();
  if (value.is_table())
    entry.kind = SceneFileEntry::Kind::section;
  else if (value.is_boolean())
    entry.value = value.as_boolean();
  else if (value.is_integer())
    entry.value = std::int64_t{value.as_integer()};
  else if (value.is_floating())
    entry.value = value.as_floating();
  else if (value.is_string())
    entry.value = value.as_string().str;
  else
    entry.kind = SceneFileEntry::Kind::unsupported;
  return entry;
}

void flatten(const std::string& prefix, const toml::value& table, std::vector<SceneFileEntry>& entries) {
  for (const auto& [leaf, value] : table.as_table()) {
    const std::string name = prefix + leaf;
    entries.push_back(entry_of(name, leaf, value));
    if (value.is_table()) flatten(name + ".", value, entries);
  }
}

/// The sections that have keys, in the order of their declaration; [scene] is always one.
std::vector<std::string> sections_of(const Settings& settings) {
  std::vector<std::string> sections{"scene"};
  for (const Key& key : settings.keys()) {
    const std::string section = key.name.substr(0, key.name.rfind('.'));
    if (std::ranges::find(sections, section) == sections.end()) sections.push_back(section);
  }
  return sections;
}

/// What is wrong with the name of an entry, or nothing.
std::string name_problem(const SceneFileEntry& entry, const Settings& settings) {
  if (settings.has(entry.name)) return "";
  if (entry.kind != SceneFileEntry::Kind::section)
    return fmt::format("there is no key \"{}\"; {}", entry.name,
                       hint(settings.nearest(entry.name), "`sphk show SCENE` lists them"));
  Settings sections;
  for (const std::string& section : sections_of(settings))
    sections.declare({.name = section, .value = false, .doc = "", .choices = {}});
  if (sections.has(entry.name)) return "";
  const std::string nearest = sections.nearest(entry.name);
  return fmt::format("there is no section [{}]; {}", entry.name,
                     nearest.empty() ? "`sphk show SCENE` lists the keys" : "did you mean [" + nearest + "]?");
}

/// What the parser says, which has file and line; with a hint for the one clash our keys invite.
std::string syntax_message(const std::string& what) {
  const bool clash = what.find("(\"scene\") already exists") != std::string::npos;
  return clash ? what + "\nA file with a section [scene] names its scene there: name = \"sod\" below [scene]." : what;
}

}  // namespace

SceneFile::SceneFile(const std::filesystem::path& path) : SceneFile(path, read_toml_file(path, "scene file")) {}

SceneFile::SceneFile(const std::filesystem::path& path, const std::string& text) : path_(path.string()) {
  try {
    flatten("", parse_toml_text(text, path_), entries_);
  } catch (const std::exception& error) {
    throw InputError(syntax_message(error.what()));
  }
  std::ranges::stable_sort(entries_, {}, [](const SceneFileEntry& e) { return std::pair(e.line, e.value_column); });
}

const SceneFileEntry* SceneFile::scene() const {
  const auto it = std::ranges::find_if(
      entries_, [](const SceneFileEntry& e) { return is_scene_name(e.name) && e.kind == SceneFileEntry::Kind::value; });
  return it == entries_.end() ? nullptr : &*it;
}

std::string SceneFile::message(const SceneFileEntry& entry, const std::string& problem, bool at_value) const {
  const int column = at_value ? entry.value_column : entry.key_column;
  const std::string number = std::to_string(entry.line);
  return fmt::format("{}:{}:{}: {}\n {} | {}\n {:{}} | {:>{}}", path_, entry.line, column, problem, number,
                     entry.line_text, "", number.size(), "^", column);
}

const std::string* SceneFile::text(const std::string& name) const {
  const auto it = std::ranges::find(entries_, name, &SceneFileEntry::name);
  return it == entries_.end() ? nullptr : std::get_if<std::string>(&it->value);
}

std::vector<std::string> SceneFile::apply(Settings& settings) const {
  std::vector<std::string> problems;
  std::string skipped = "\n";  // what lies in an unknown section
  for (const SceneFileEntry& entry : entries_) {
    const bool section = entry.kind == SceneFileEntry::Kind::section;
    if (is_scene_name(entry.name) || entry.name.starts_with(skipped)) continue;
    if (const std::string problem = name_problem(entry, settings); !problem.empty()) {
      problems.push_back(message(entry, problem, false));
      if (section) skipped = entry.name + ".";
    } else if (settings.has(entry.name) && entry.kind != SceneFileEntry::Kind::value) {
      problems.push_back(message(entry, entry.name + ": one number, string, true or false is wanted here", true));
    } else if (!section) {
      try {
        settings.set(entry.name, checked_unit(entry.name, entry.value), Origin::file);
      } catch (const InputError& error) {
        problems.push_back(message(entry, error.what(), true));
      }
    }
  }
  return problems;
}

std::string used_scene_file(const Settings& settings, const std::string& scene) {
  const char* origin[] = {"default", "the scene's choice", "from the scene file", "from the command line"};
  std::string text = fmt::format("[scene]\nname = \"{}\"\n", scene);
  for (const std::string& section : sections_of(settings)) {
    if (section != "scene") text += fmt::format("\n[{}]\n", section);
    for (const Key& key : settings.keys()) {
      const auto dot = key.name.rfind('.');
      if (key.name.substr(0, dot) != section) continue;
      const std::string assignment = fmt::format("{} = {}", key.name.substr(dot + 1), to_text(key.value));
      text += fmt::format("{:<28}  # {}; {}\n", assignment, origin[static_cast<int>(key.origin)], key.doc);
    }
  }
  return text;
}

}  // namespace sphk
