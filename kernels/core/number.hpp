// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kernels/core/unit.hpp"

namespace sphk {

/// A number that users may set, owned by the term or pass that reads it: its key in scene files, default, meaning and
/// range. Host only.
struct Number {
  const char* key;
  double standard;
  const char* meaning;  ///< one line, with its equation
  double min = 0, max = 1e300;
  const char* words = nullptr;  ///< "this|that": users choose a word, and the number is its place
  Unit unit{};
};

/// What a number that is on or off takes.
inline constexpr const char* off_or_on = "false|true";

/// The numbers of a term or pass.
template <const Number&... all>
struct Numbers {
  static constexpr std::array<const Number*, sizeof...(all)> list{&all...};
};

/// Values that a run gives to numbers, by key; all others keep their defaults. Host only.
class Given {
 public:
  Given() = default;
  Given(std::initializer_list<std::pair<std::string, double>> values) : values_(values) {}

  double operator[](const Number& number) const { return value_or(number.key, number.standard); }
  double value_or(std::string_view key, double standard) const {
    for (const auto& [name, value] : values_)
      if (name == key) return value;
    return standard;
  }
  bool has(std::string_view key) const {
    for (const auto& [name, value] : values_)
      if (name == key) return true;
    return false;
  }
  void set(std::string_view key, double value) {
    for (auto& [name, old] : values_)
      if (name == key) return void(old = value);
    values_.emplace_back(key, value);
  }
  const std::vector<std::pair<std::string, double>>& values() const { return values_; }

 private:
  std::vector<std::pair<std::string, double>> values_;
};

/// Numbers<...> of a term or pass T, none where it has none.
template <class T>
struct NumbersOf {
  using type = Numbers<>;
};
template <class T>
requires requires {
  typename T::Numbers;
}
struct NumbersOf<T> {
  using type = typename T::Numbers;
};

}  // namespace sphk
