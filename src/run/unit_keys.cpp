// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/unit_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "src/engine/errors.hpp"

namespace sphk {

namespace {

const std::string code = "code";

struct UnitKey {
  UnitOf kind;
  const char *name, *doc;
};
constexpr std::array unit_keys{
    UnitKey{UnitOf::length, "units.length",
            "unit of the numbers: a name (\"kpc\"), a number of it (\"10 kpc\"), or a number in cgs; code: none"},
    UnitKey{UnitOf::mass, "units.mass", "unit of masses, such as \"1e10 Msun\""},
    UnitKey{UnitOf::time, "units.time", "unit of times, such as \"Gyr\"; or units.velocity says it"},
    UnitKey{UnitOf::velocity, "units.velocity", "unit of velocities, such as \"km/s\"; or units.time says it"}};

const char* name_of(UnitOf kind) {
  return std::ranges::find(unit_keys, kind, &UnitKey::kind)->name;
}

/// In cgs, where it is given.
std::optional<double> given(const Settings& settings, UnitOf kind) {
  const std::string& text = settings.text(name_of(kind));
  if (text == code) return std::nullopt;
  try {
    return unit_in_cgs(kind, text);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", name_of(kind), error.what()));
  }
}

bool differ(double a, double b) {
  return std::abs(a - b) > 1e-9 * b;
}

}  // namespace

void declare_unit_keys(Settings& settings) {
  for (const UnitKey& key : unit_keys)
    settings.declare({.name = key.name, .value = code, .doc = key.doc, .choices = {}});
}

void prefer_units(Settings& settings, const Units& units) {
  for (const auto& [kind, value] : {std::pair{UnitOf::length, units.length}, std::pair{UnitOf::mass, units.mass},
                                    std::pair{UnitOf::time, units.time}})
    settings.prefer(name_of(kind), fmt::format("{}", value));
}

Value checked_unit(const std::string& key, const Value& value) {
  const auto unit = std::ranges::find(unit_keys, key, &UnitKey::name);
  if (unit == unit_keys.end() || std::holds_alternative<bool>(value)) return value;
  const auto* text = std::get_if<std::string>(&value);
  const std::string said = text ? *text : to_text(value);
  if (said != code) unit_in_cgs(unit->kind, said);
  return said;
}

void settle_units(Settings& settings) {
  const char *time = name_of(UnitOf::time), *velocity = name_of(UnitOf::velocity);
  if (settings.text(velocity) != code && !settings.set_by_user(time)) settings.forget_preference(time, code);
  units_of(settings);
}

std::optional<Units> units_of(const Settings& settings) {
  const auto length = given(settings, UnitOf::length), mass = given(settings, UnitOf::mass);
  const auto time = given(settings, UnitOf::time), velocity = given(settings, UnitOf::velocity);
  if (!length && !mass && !time && !velocity) return std::nullopt;
  if (time && velocity)
    throw InputError("units.time and units.velocity are both given: either follows from the other, so remove one");
  if (!length || !mass || !(time || velocity))
    throw InputError(
        fmt::format("{} is not given: a unit of length, one of mass, and one of time or of velocity belong "
                    "together",
                    !length ? "units.length"
                    : !mass ? "units.mass"
                            : "units.time or units.velocity"));
  return Units{*length, *mass, time ? *time : *length / *velocity};
}

std::vector<std::string> unit_remarks(const std::optional<Units>& units, const std::optional<Units>& of_file) {
  std::vector<std::string> remarks;
  if (units) remarks.push_back("all numbers are in " + units_text(units));
  if (of_file && (!units || differ(units->length, of_file->length) || differ(units->mass, of_file->mass) ||
                  differ(units->time, of_file->time)))
    remarks.push_back(fmt::format(
        "the file says that its units are {}: its numbers are taken for {} as [units] asks, and not converted",
        units_text(of_file), units_text(units)));
  return remarks;
}

}  // namespace sphk
