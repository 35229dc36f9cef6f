// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/toml_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string_view>

#include "src/engine/errors.hpp"
#include "src/io/input_file.hpp"

namespace sphk {

namespace {

constexpr int max_brackets = 16;  ///< open at the same place: a list of lists has 2
constexpr int max_dots = 16;      ///< of one name

/// Bytes of the UTF-8 character that `text` begins with; 0 where it begins with none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < length) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(k) & 0xc0) != 0x80) return 0;
  const bool too_long = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
  const bool surrogate = first == 0xed && byte(1) > 0x9f;
  const bool too_large = first == 0xf4 && byte(1) > 0x8f;
  return too_long || surrogate || too_large ? 0 : length;
}

/// Characters of the string or comment that `text` begins with, quotes included; 0 where it begins with neither.
std::size_t skipped(std::string_view text) {
  if (text[0] == '#') return std::min(text.find('\n'), text.size());
  if (text[0] != '"' && text[0] != '\'') return 0;
  const bool escapes = text[0] == '"';
  const std::string triple(3, text[0]);
  const std::string_view quote = text.starts_with(triple) ? std::string_view(triple) : text.substr(0, 1);
  for (std::size_t k = quote.size(); k < text.size(); ++k) {
    if (quote.size() == 1 && text[k] == '\n') return k;  // it lacks its end
    if (text.substr(k).starts_with(quote)) return k + quote.size();
    if (escapes && text[k] == '\\') ++k;
  }
  return text.size();
}

/// Where in a text something is wrong, and what.
struct Fault {
  std::size_t at;
  const char* problem;
};

std::optional<Fault> wrong_character(std::string_view text) {
  for (std::size_t k = 0, length = 0; k < text.size(); k += length)
    if (length = utf8_length(text.substr(k)); length == 0)
      return Fault{k, "this is not UTF-8 text; save the file as UTF-8"};
  return std::nullopt;
}

std::optional<Fault> deep_nesting(std::string_view text) {
  int brackets = 0, dots = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (const std::size_t length = skipped(text.substr(k))) {
      k += length - 1;
      continue;
    }
    const char c = text[k];
    if (c == '[' || c == '{') ++brackets;
    if (c == ']' || c == '}') --brackets;
    if (c == '.') ++dots;
    if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos) dots = 0;
    if (brackets > max_brackets) return Fault{k, "brackets are nested too deeply here; close those before"};
    if (dots > max_dots) return Fault{k, "a name has too many dots; name the key as in `sphk show SCENE`"};
  }
  return std::nullopt;
}

}  // namespace

std::string read_toml_file(const std::filesystem::path& path, const std::string& what) {
  try {
    require_file(path);
  } catch (const InputError& error) {
    throw InputError(fmt::format("cannot read the {} {}", what, error.what()));
  }
  std::ifstream file(path, std::ios::binary);
  if (file) return {std::istreambuf_iterator<char>(file), {}};
  throw InputError(fmt::format("cannot read the {} {}: may it be read by you?", what, path.string()));
}

toml::value parse_toml(const std::filesystem::path& path, const std::string& what) {
  return parse_toml_text(read_toml_file(path, what), path.string());
}

toml::value parse_toml_text(const std::string& text, const std::string& name) {
  for (const auto find_fault : {wrong_character, deep_nesting})
    if (const auto fault = find_fault(text)) {
      const std::string_view before(text.data(), fault->at);
      throw InputError(fmt::format("{}:{}:{}: {}", name, 1 + std::ranges::count(before, '\n'),
                                   fault->at - (before.rfind('\n') + 1) + 1, fault->problem));
    }
  try {
    std::istringstream stream(text);
    return toml::parse(stream, name);
  } catch (const std::exception& error) {
    throw InputError(error.what());
  }
}

}  // namespace sphk
