// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "src/engine/settings.hpp"

namespace sphk {

/// One `key = value` of a scene file: where it stands, for error messages.
struct SceneFileEntry {
  enum class Kind { value, section, unsupported };
  std::string name;  ///< full path, such as "sph.kernel"
  Value value;       ///< meaningful for Kind::value
  Kind kind = Kind::value;
  int line = 0;
  int key_column = 0, value_column = 0;  ///< from 1
  std::string line_text;
};

/// A scene file (TOML) as a flat list of keys, in the file's order. The scene's name is the key "scene" (`scene =
/// "sod"` before all sections) or "scene.name" (`name = "sod"` in the section [scene], where the scene has keys of its
/// own).
class SceneFile {
 public:
  /// Throws InputError when the file cannot be read or is not TOML, with line, column and caret.
  explicit SceneFile(const std::filesystem::path& path);
  /// The same of a text that is to stand in the file.
  SceneFile(const std::filesystem::path& path, const std::string& text);

  const std::string& path() const { return path_; }
  /// The scene's name entry, or null.
  const SceneFileEntry* scene() const;
  /// The string that key `name` holds in this file, or null.
  const std::string* text(const std::string& name) const;
  /// Sets every key in `settings`; returns a message for each that is unknown, has the wrong type or is out of range.
  std::vector<std::string> apply(Settings& settings) const;
  /// "file:line:column: problem", the line and a caret below the key (or below the value).
  std::string message(const SceneFileEntry& entry, const std::string& problem, bool at_value) const;

 private:
  std::string path_;
  std::vector<SceneFileEntry> entries_;
};

/// The complete scene file of a run: every key with its value, who set it, and what it means.
std::string used_scene_file(const Settings& settings, const std::string& scene);

}  // namespace sphk
