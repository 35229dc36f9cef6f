// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "src/engine/errors.hpp"
#include "src/engine/hint.hpp"

namespace sphk {

namespace {

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    int diagonal = row[0];
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int substituted = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row.back();
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

/// A choice that is written in another case.
Value in_the_choices_case(const Key& key, const Value& value) {
  const auto* text = std::get_if<std::string>(&value);
  if (!text || std::ranges::find(key.choices, *text) != key.choices.end()) return value;
  const auto same = [&](const std::string& choice) { return lower_case(choice) == lower_case(*text); };
  if (std::ranges::count_if(key.choices, same) != 1) return value;
  return *std::ranges::find_if(key.choices, same);
}

const char* type_name(const Value& value) {
  constexpr const char* names[] = {"true or false", "an integer", "a number", "a string"};
  return names[value.index()];
}

Value converted(const Key& key, const Value& value) {
  if (value.index() == key.value.index()) return value;
  if (std::holds_alternative<double>(key.value) && std::holds_alternative<std::int64_t>(value))
    return static_cast<double>(std::get<std::int64_t>(value));
  throw InputError(fmt::format("{} = {}: {} is wanted here", key.name, to_text(value), type_name(key.value)));
}

void check_range(const Key& key, const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) {
    if (key.choices.empty() || std::ranges::find(key.choices, *text) != key.choices.end()) return;
    throw InputError(fmt::format("{} = \"{}\": choose one of {}", key.name, *text, fmt::join(key.choices, ", ")));
  }
  double number = 0;
  if (const auto* integer = std::get_if<std::int64_t>(&value))
    number = static_cast<double>(*integer);
  else if (const auto* real = std::get_if<double>(&value))
    number = *real;
  else
    return;
  if (!std::isfinite(number))
    throw InputError(fmt::format("{} = {}: a finite number is wanted here{}", key.name, to_text(value),
                                 std::isfinite(key.min) || std::isfinite(key.max)
                                     ? fmt::format("; it must lie between {} and {}", key.min, key.max)
                                     : ""));
  if (!(number >= key.min && number <= key.max))
    throw InputError(fmt::format("{} = {}: it must lie between {} and {}", key.name, to_text(value), key.min, key.max));
}

/// A basic string of TOML.
std::string quoted(std::string_view text) {
  std::string all = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      all += {'\\', c};
    else if (byte < 0x20 || byte == 0x7f)
      all += fmt::format("\\u{:04x}", byte);
    else
      all += c;
  }
  return all + '"';
}

template <class T>
bool parse(std::string_view text, T& out) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  return error == std::errc{} && end == text.data() + text.size();
}

/// What the text of a value means where the key is wanted.
Value parsed(const Key& key, std::string_view text) {
  double real = 0;
  std::int64_t integer = 0;
  if (std::holds_alternative<std::string>(key.value)) return std::string(text);
  if (text == "true" || text == "false") return text == "true";
  if (parse(text, integer)) return integer;
  if (parse(text, real)) return real;
  throw InputError(fmt::format("{} = {}: {} is wanted here", key.name, text, type_name(key.value)));
}

}  // namespace

std::string to_text(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return quoted(*text);
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *integer);
  const std::string text = fmt::format("{}", std::get<double>(value));
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

void Settings::declare(Key key) {
  if (has(key.name)) throw std::logic_error("the key " + key.name + " is declared twice");
  keys_.push_back(std::move(key));
}

void Settings::prefer(std::string_view name, Value value) {
  Key& key = const_cast<Key&>(find(name));
  key.preferred = converted(key, value);
  if (!set_by_user(name)) set(name, value, Origin::scene);
}

void Settings::set_standard(std::string_view name, Value value) {
  if (find(name).origin == Origin::standard) set(name, value, Origin::standard);
}

void Settings::forget_preference(std::string_view name, Value standard) {
  const_cast<Key&>(find(name)).preferred.reset();
  if (!set_by_user(name)) set(name, standard, Origin::standard);
}

void Settings::remove(std::string_view name) {
  std::erase_if(keys_, [&](const Key& key) { return key.name == name; });
}

void Settings::set(std::string_view name, const Value& value, Origin origin) {
  Key& key = const_cast<Key&>(find(name));
  const Value typed = in_the_choices_case(key, converted(key, value));
  check_range(key, typed);
  key.value = typed;
  key.origin = origin;
}

void Settings::set_from_text(std::string_view name, std::string_view text, Origin origin) {
  set(name, parsed(find(name), text), origin);
}

void Settings::prefer_from_text(std::string_view name, std::string_view text) {
  prefer(name, parsed(find(name), text));
}

bool Settings::has(std::string_view name) const {
  return std::ranges::any_of(keys_, [&](const Key& key) { return key.name == name; });
}

/// Whole names are compared, their last parts, and a last part with sections: "[sph] viscosty" is near to a key of
/// [viscosity]. Near is what differs in a third of its letters at most.
std::string Settings::nearest(std::string_view name) const {
  const auto leaf = [](std::string_view path) { return path.substr(path.rfind('.') + 1); };
  std::string best;
  int least = std::numeric_limits<int>::max();
  for (const Key& key : keys_) {
    const std::string_view known = key.name, section = known.substr(0, known.size() - leaf(known).size());
    const std::pair<std::string_view, std::string_view> pairs[] = {
        {name, known}, {leaf(name), leaf(known)}, {leaf(name), section.substr(0, section.find('.'))}};
    for (int farther = 0; const auto& [given, other] : pairs) {
      const int distance = edit_distance(lower_case(given), lower_case(other));
      const int near = given.size() < 3 ? 0 : static_cast<int>(given.size() + 1) / 3;
      if (distance <= near && distance + farther < least) least = distance + farther, best = known;
      ++farther;
    }
  }
  return best;
}

const Key& Settings::find(std::string_view name) const {
  const auto it = std::ranges::find(keys_, name, &Key::name);
  if (it == keys_.end())
    throw InputError(
        fmt::format("there is no key \"{}\"; {}", name, hint(nearest(name), "`sphk show SCENE` lists them")));
  return *it;
}

}  // namespace sphk
