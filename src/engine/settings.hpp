// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace sphk {

using Value = std::variant<bool, std::int64_t, double, std::string>;

/// Who decided a value; later ones win.
enum class Origin { standard, scene, file, command_line };

/// One configuration key: `name` is its path in a scene file, such as "sph.kernel".
struct Key {
  std::string name;
  Value value;                       ///< the default; its type is the key's type
  std::string doc;                   ///< one line, with the unit
  std::vector<std::string> choices;  ///< allowed strings; empty: any
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  Origin origin = Origin::standard;
  std::optional<Value> preferred{};  ///< what the scene would have, whoever set the value
};

/// Every key that a run knows, with its value and who set it. Unknown names, wrong types and values out of range throw
/// InputError with the nearest name or the allowed values.
class Settings {
 public:
  void declare(Key key);
  /// Changes the default of a declared key (a scene's own choice), and the value where no user has set it.
  void prefer(std::string_view name, Value value);
  /// The same with a text that is parsed by the key's type.
  void prefer_from_text(std::string_view name, std::string_view text);
  /// Gives a key that nobody has set another default.
  void set_standard(std::string_view name, Value value);
  /// Takes a scene's choice back, where no user has set the value.
  void forget_preference(std::string_view name, Value standard);
  void remove(std::string_view name);
  /// An integer is accepted where a real is wanted.
  void set(std::string_view name, const Value& value, Origin origin);
  /// Parses `text` by the key's type, as in `--set name=text`.
  void set_from_text(std::string_view name, std::string_view text, Origin origin);

  template <class T>
  const T& get(std::string_view name) const {
    return std::get<T>(find(name).value);
  }
  bool flag(std::string_view name) const { return get<bool>(name); }
  std::int64_t integer(std::string_view name) const { return get<std::int64_t>(name); }
  double real(std::string_view name) const { return get<double>(name); }
  const std::string& text(std::string_view name) const { return get<std::string>(name); }

  bool has(std::string_view name) const;
  bool set_by_user(std::string_view name) const { return find(name).origin > Origin::scene; }
  const std::vector<Key>& keys() const { return keys_; }
  /// The known name that is near to `name` by edit distance, in any section, for error messages; empty where none is.
  std::string nearest(std::string_view name) const;

 private:
  const Key& find(std::string_view name) const;
  std::vector<Key> keys_;
};

/// `value` as TOML would write it.
std::string to_text(const Value& value);

}  // namespace sphk
