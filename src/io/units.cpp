// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/units.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <ranges>
#include <span>
#include <stdexcept>
#include <vector>

#include "src/engine/errors.hpp"

namespace sphk {

namespace {

struct NamedUnit {
  const char* name;
  double cgs;
};

/// Rising. The astronomical unit and with it the parsec are exact (IAU 2012, 2015).
constexpr NamedUnit lengths[] = {{"cm", 1},
                                 {"m", 1e2},
                                 {"km", 1e5},
                                 {"Rsun", 6.957e10},  // IAU 2015
                                 {"AU", 1.495978707e13},
                                 {"pc", 3.0856775814913673e18},
                                 {"kpc", 3.0856775814913673e21},
                                 {"Mpc", 3.0856775814913673e24}};
constexpr NamedUnit masses[] = {{"g", 1},
                                {"kg", 1e3},
                                {"Mearth", 5.9722e27},
                                {"Msun", 1.98841e33}};  // GM of IAU 2015 over G of CODATA 2018, as SWIFT has it
constexpr double year = 365.25 * 86400;                 // Julian
constexpr NamedUnit times[] = {{"s", 1},     {"min", 60},         {"h", 3600},         {"day", 86400},
                               {"yr", year}, {"kyr", 1e3 * year}, {"Myr", 1e6 * year}, {"Gyr", 1e9 * year}};
/// The usual ones; any length over any time is taken.
constexpr NamedUnit velocities[] = {{"cm/s", 1}, {"m/s", 1e2}, {"km/s", 1e5}};

constexpr double least = 1e-60, most = 1e60;  // so that no product of units under- or overflows
constexpr double same = 1e-3;                 // codes differ by so much on the mass of the sun

std::span<const NamedUnit> named(UnitOf kind) {
  switch (kind) {
    case UnitOf::length:
      return lengths;
    case UnitOf::mass:
      return masses;
    case UnitOf::time:
      return times;
    case UnitOf::velocity:
      return velocities;
  }
  return {};
}

const char* word(UnitOf kind) {
  constexpr const char* words[] = {"length", "mass", "time", "velocity"};
  return words[static_cast<int>(kind)];
}

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

std::optional<double> cgs_of(UnitOf kind, std::string_view name) {
  for (const NamedUnit& unit : named(kind))
    if (unit.name == name) return unit.cgs;
  const auto slash = name.find('/');
  if (kind != UnitOf::velocity || slash == std::string_view::npos) return std::nullopt;
  const auto length = cgs_of(UnitOf::length, trimmed(name.substr(0, slash)));
  const auto time = cgs_of(UnitOf::time, trimmed(name.substr(slash + 1)));
  return length && time ? std::optional(*length / *time) : std::nullopt;
}

[[noreturn]] void refuse(UnitOf kind, std::string_view text) {
  std::vector<std::string> names;
  for (const NamedUnit& unit : named(kind)) names.emplace_back(unit.name);
  throw InputError(
      fmt::format("\"{}\" is no unit of {}: write {}{}, a positive number of one, as in \"10 {}\", or a "
                  "number alone, in cgs",
                  text, word(kind), fmt::join(names, ", "),
                  kind == UnitOf::velocity ? ", or a unit of length over one of time" : "", names.back()));
}

/// The power of ten that a number is to within `same`.
std::optional<int> power_of_ten(double value) {
  const double exponent = std::round(std::log10(value));
  if (std::abs(value / std::pow(10, exponent) - 1) > same) return std::nullopt;
  return static_cast<int>(exponent);
}

std::string number_of(int power, const char* unit) {
  if (power == 0) return unit;
  return std::abs(power) <= 3 ? fmt::format("{:g} {}", std::pow(10, power), unit) : fmt::format("1e{} {}", power, unit);
}

/// A unit to a power, as in "(km/s)^2".
std::string power(const std::string& unit, double exponent) {
  if (exponent == 1) return unit;
  const bool compound = unit.find_first_of(" /") != std::string::npos;
  return fmt::format("{}^{:.3g}", compound ? "(" + unit + ")" : unit, exponent);
}

/// Its own name, or that of a length over that of a time where these are plain ones.
std::string velocity_name(const Units& units) {
  const auto is_plain = [](const std::string& name) { return name.find(' ') == std::string::npos; };
  const std::string length = unit_name(UnitOf::length, units.length), time = unit_name(UnitOf::time, units.time);
  const std::string name = unit_name(UnitOf::velocity, units.velocity());
  return is_plain(name) || !is_plain(length) || !is_plain(time) ? name : length + "/" + time;
}

}  // namespace

double Units::to_cgs(const UnitExponents& exponents) const {
  return std::pow(length, exponents.length) * std::pow(mass, exponents.mass) * std::pow(time, exponents.time);
}

double unit_in_cgs(UnitOf kind, std::string_view text) {
  double number = 1;
  std::string_view name = trimmed(text);
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (error == std::errc::result_out_of_range) refuse(kind, text);
  if (error == std::errc()) name = trimmed({end, name.data() + name.size()});
  if (name.empty() && error != std::errc()) refuse(kind, text);
  const auto unit = name.empty() ? std::optional(1.0) : cgs_of(kind, name);
  if (!unit || !(number > 0 && std::isfinite(number))) refuse(kind, text);
  const double cgs = number * *unit;
  if (!(cgs >= least && cgs <= most))
    throw InputError(
        fmt::format("\"{}\" is no unit of {}: in cgs it must lie between {} and {}", text, word(kind), least, most));
  return cgs;
}

std::string unit_name(UnitOf kind, double cgs) {
  const NamedUnit* largest = &named(kind).front();
  for (const NamedUnit& unit : named(kind)) {
    if (power_of_ten(cgs / unit.cgs) == 0) return unit.name;
    if (unit.cgs < cgs) largest = &unit;
  }
  for (const NamedUnit& unit : named(kind) | std::views::reverse)
    if (const auto power = power_of_ten(cgs / unit.cgs); power && *power > 0) return number_of(*power, unit.name);
  return fmt::format("{:.5g} {}", cgs / largest->cgs, largest->name);
}

std::string units_text(const std::optional<Units>& units) {
  if (!units) return "code units";
  return fmt::format("{}, {}, {} and {}", unit_name(UnitOf::length, units->length),
                     unit_name(UnitOf::mass, units->mass), velocity_name(*units), unit_name(UnitOf::time, units->time));
}

std::string unit_label(const Units& units, std::string_view quantity, int dimension, double gamma) {
  const std::string length = unit_name(UnitOf::length, units.length), mass = unit_name(UnitOf::mass, units.mass);
  const std::string velocity = velocity_name(units);
  const std::string density = mass + " " + power(length, -dimension), specific = power(velocity, 2);
  if (quantity == "x") return length;
  if (quantity == "m") return mass;
  if (quantity == "t") return unit_name(UnitOf::time, units.time);
  if (quantity == "v") return velocity;
  if (quantity == "u") return specific;
  if (quantity == "rho") return density;
  if (quantity == "P") return density + " " + specific;
  if (quantity == "A") return specific + " " + power(density, 1 - gamma);
  if (quantity == "energy") return mass + " " + specific;
  throw std::logic_error("no unit is known of " + std::string(quantity));
}

}  // namespace sphk
