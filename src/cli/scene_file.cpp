#include "src/cli/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <toml.hpp>

#include "src/engine/errors.hpp"

namespace sphk {

namespace {

bool is_scene_name(const std::string& name) { return name == "scene" || name == "scene.name"; }

/// Where the key stands in its line: the last occurrence of its name before the value.
int key_column(const std::string& line, const std::string& leaf, int value_column) {
  const auto at = line.rfind(leaf, static_cast<std::size_t>(value_column - 1));
  return at == std::string::npos ? value_column : static_cast<int>(at) + 1;
}

SceneFileEntry entry_of(const std::string& name, const std::string& leaf, const toml::value& value) {
  const auto place = value.location();
  SceneFileEntry entry{.name = name, .value = {}, .line = static_cast<int>(place.line())};
  entry.value_column = static_cast<int>(place.column());
  entry.key_column = key_column(place.line_str(), leaf, entry.value_column);
  entry.line_text = place.line_str();
  if (value.is_table()) entry.kind = SceneFileEntry::Kind::section;
  else if (value.is_boolean()) entry.value = value.as_boolean();
  else if (value.is_integer()) entry.value = std::int64_t{value.as_integer()};
  else if (value.is_floating()) entry.value = value.as_floating();
  else if (value.is_string()) entry.value = value.as_string().str;
  else entry.kind = SceneFileEntry::Kind::unsupported;
  return entry;
}

void flatten(const std::string& prefix, const toml::value& table, std::vector<SceneFileEntry>& entries) {
  for (const auto& [leaf, value] : table.as_table()) {
    const std::string name = prefix + leaf;
    entries.push_back(entry_of(name, leaf, value));
    if (value.is_table()) flatten(name + ".", value, entries);
  }
}

bool has_section(const Settings& settings, const std::string& name) {
  const auto inside = [&](const Key& key) { return key.name.starts_with(name + "."); };
  return name == "scene" || std::ranges::any_of(settings.keys(), inside);
}

/// toml11's own message, which has file, line and caret; with a hint for the one clash our keys invite.
std::string syntax_message(const std::string& what) {
  const bool clash = what.find("(\"scene\") already exists") != std::string::npos;
  return clash ? what + "\nA file with a section [scene] names its scene there: name = \"sod\" below [scene]." : what;
}

}  // namespace

SceneFile::SceneFile(const std::filesystem::path& path) : path_(path.string()) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(fmt::format("cannot read the scene file {}: is the path right?", path_));
  try {
    flatten("", toml::parse(file, path_), entries_);
  } catch (const std::exception& error) {
    throw InputError(syntax_message(error.what()));
  }
  std::ranges::stable_sort(entries_, {}, [](const SceneFileEntry& e) { return std::pair(e.line, e.value_column); });
}

const SceneFileEntry* SceneFile::scene() const {
  const auto it = std::ranges::find_if(entries_, [](const SceneFileEntry& e) {
    return is_scene_name(e.name) && e.kind == SceneFileEntry::Kind::value;
  });
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
  std::string unknown_section;
  for (const SceneFileEntry& entry : entries_) {
    if (is_scene_name(entry.name)) continue;
    if (!unknown_section.empty() && entry.name.starts_with(unknown_section)) continue;
    if (entry.kind == SceneFileEntry::Kind::section && !settings.has(entry.name)) {
      if (has_section(settings, entry.name)) continue;
      unknown_section = entry.name + ".";
      const std::string nearest = settings.nearest(entry.name);
      problems.push_back(message(entry, fmt::format("there is no section [{}]; the nearest key is \"{}\"", entry.name, nearest), false));
    } else if (!settings.has(entry.name)) {
      const std::string nearest = settings.nearest(entry.name);
      problems.push_back(message(entry, fmt::format("there is no key \"{}\"; did you mean \"{}\"?", entry.name, nearest), false));
    } else if (entry.kind != SceneFileEntry::Kind::value) {
      problems.push_back(message(entry, fmt::format("{}: one number, string, true or false is wanted here", entry.name), true));
    } else {
      try {
        settings.set(entry.name, entry.value, Origin::file);
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
  std::vector<std::string> sections{"scene"};
  for (const Key& key : settings.keys()) {
    const std::string section = key.name.substr(0, key.name.rfind('.'));
    if (std::ranges::find(sections, section) == sections.end()) sections.push_back(section);
  }
  for (const std::string& section : sections) {
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
