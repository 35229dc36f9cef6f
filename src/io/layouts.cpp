// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/layouts.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <initializer_list>

#include "src/engine/errors.hpp"

namespace sphk {

namespace {

/// An attribute of a group: one place where a layout may have a fact.
struct Place {
  const char* group;
  const char* name;
  std::string text() const { return fmt::format("the attribute \"{}\" of {}", name, group); }
};
using Places = std::initializer_list<Place>;

constexpr Places periodic_places = {{"RuntimePars", "PeriodicBoundariesOn"},       // SWIFT before 0.9
                                    {"Parameters", "InitialConditions:periodic"},  // SWIFT since
                                    {"Parameters", "PeriodicBoundariesOn"},        // AREPO
                                    {"Header", "PeriodicBoundariesOn"}};
constexpr Places periodic_flags = {
    {"Config", "PERIODIC"}, {"Config", "BOX_PERIODIC"}, {"Header", "PERIODIC"}, {"Header", "BOX_PERIODIC"}};
constexpr Places comoving_places = {{"Cosmology", "Cosmological run"},        // SWIFT
                                    {"Policy", "cosmological integration"},   // SWIFT
                                    {"Parameters", "ComovingIntegrationOn"},  // GADGET-4, AREPO
                                    {"Header", "ComovingIntegrationOn"}};     // GIZMO
constexpr Places matter_places = {{"Header", "Omega0"},                       // GADGET-2
                                  {"Header", "Omega_Matter"},                 // GIZMO
                                  {"Parameters", "Omega0"}};
constexpr Places dimension_places = {{"HydroScheme", "Dimension"}, {"Header", "Dimension"}};
constexpr Places wall_flags = {{"Config", "REFLECTIVE_X"}, {"Config", "REFLECTIVE_Y"}, {"Config", "REFLECTIVE_Z"}};

bool has(const hdf5::File& file, const Place& place) {
  return file.has(place.group) && file.group(place.group).has_attribute(place.name);
}

/// The number there; those that SWIFT writes as text as well.
std::optional<double> number_at(const hdf5::File& file, const Place& place) {
  if (!has(file, place)) return std::nullopt;
  const hdf5::Group group = file.group(place.group);
  if (!group.is_text(place.name)) return group.number_or(place.name, 0);
  const std::string text = group.text(place.name);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size()) return value;
  throw InputError(fmt::format("{}: {} is \"{}\", but a number is wanted; mend it", file.where(), place.text(), text));
}

std::optional<double> number_at(const hdf5::File& file, Places places) {
  for (const Place& place : places)
    if (const auto value = number_at(file, place)) return value;
  return std::nullopt;
}

/// A compile-time option, which GADGET-4 lists by its name alone.
bool is_set(const hdf5::File& file, const Place& place) {
  if (!has(file, place)) return false;
  const hdf5::Group group = file.group(place.group);
  return (group.is_text(place.name) && group.text(place.name).empty()) || number_at(file, place) != 0;
}

bool any_set(const hdf5::File& file, Places flags) {
  for (const Place& flag : flags)
    if (is_set(file, flag)) return true;
  return false;
}

bool is_periodic_said(const hdf5::File& file, Places flags) {
  if (file.has("Config")) return true;  // all options are listed there: what is not, is off
  for (const Place& flag : flags)
    if (has(file, flag)) return true;
  return false;
}

/// What the places say, which must be one thing.
std::optional<bool> periodic(const hdf5::File& file) {
  std::optional<bool> said;
  const Place* by = nullptr;
  for (const Place& place : periodic_places) {
    const auto value = number_at(file, place);
    if (!value) continue;
    if (said && *said != (*value != 0))
      throw InputError(
          fmt::format("{}: whether the box is periodic, {} and {} say different things; change one of them",
                      file.where(), by->text(), place.text()));
    said = *value != 0;
    by = &place;
  }
  if (!said && is_periodic_said(file, periodic_flags)) return any_set(file, periodic_flags);
  return said;
}

[[noreturn]] void refuse_comoving(const hdf5::File& file, const std::string& because, const std::string& remedy) {
  throw InputError(
      fmt::format("{}: {}: the file is in comoving units of a cosmological run, which sphk does not know; convert it "
                  "to physical units and {}",
                  file.where(), because, remedy));
}

/// GADGET-2 has no word for it: its comoving files have a redshift, and the scale factor as their time.
void refuse_comoving_header(const hdf5::File& file) {
  constexpr double rounding = 1e-6;  // of a scale factor in float
  const hdf5::Group header = file.group("Header");
  for (const auto& [name, standard] : {std::pair{"Redshift", 0.0}, std::pair{"Scale-factor", 1.0}})
    if (const double value = header.number_or(name, standard); value != standard)
      refuse_comoving(file, fmt::format("the attribute \"{}\" of Header is {}", name, value),
                      fmt::format("set it to {}", standard));
  const double matter = number_at(file, matter_places).value_or(0), time = header.number_or("Time", 0);
  if (matter > 0 && std::abs(time - 1) < rounding)
    refuse_comoving(file,
                    fmt::format("the density of matter is {} in its Header, and Time is the scale factor 1", matter),
                    "set Omega0 to 0");
}

void refuse_comoving(const hdf5::File& file) {
  bool said = false;
  for (const Place& place : comoving_places)
    if (const auto value = number_at(file, place)) {
      if (*value != 0) refuse_comoving(file, fmt::format("{} is {}", place.text(), *value), "set it to 0");
      said = true;
    }
  if (!said) refuse_comoving_header(file);
}

std::optional<double> dimension(const hdf5::File& file) {
  if (const auto said = number_at(file, dimension_places)) return said;
  for (const char* group : {"Config", "Header"}) {
    if (is_set(file, {group, "ONEDIMS"})) return 1;
    if (is_set(file, {group, "TWODIMS"})) return 2;
    if (const auto said = number_at(file, {group, "BOX_SPATIAL_DIMENSION"})) return said;  // GIZMO
  }
  return file.has("Config") ? std::optional(3.0) : std::nullopt;
}

std::optional<double> gamma(const hdf5::File& file) {
  if (is_set(file, {"Config", "ISOTHERM_EQS"})) return 1;
  if (const auto said = number_at(file, {{"HydroScheme", "Adiabatic index"}, {"Config", "GAMMA"}, {"Header", "GAMMA"}}))
    return said;
  return file.has("Config") ? std::optional(5.0 / 3) : std::nullopt;  // what those codes take without that option
}

/// A unit in cgs, where one of the places has it.
std::optional<double> unit(const hdf5::File& file, Places places) {
  for (const Place& place : places) {
    const auto value = number_at(file, place);
    if (value && !(*value > 0 && std::isfinite(*value)))
      throw InputError(fmt::format("{}: {} is {}; set it to the unit in cgs, a positive number, or remove it",
                                   file.where(), place.text(), *value));
    if (value) return value;
  }
  return std::nullopt;
}

/// sphk's own files say apart whether their units are those of the code, which others take for cgs.
bool has_code_units(const hdf5::File& file) {
  return file.has("sphk") && number_at(file, {"sphk", "CodeUnits"}).value_or(1) != 0;
}

std::optional<Units> units(const hdf5::File& file) {
  if (has_code_units(file)) return std::nullopt;
  const auto length = unit(file, {{"Units", "Unit length in cgs (U_L)"},
                                  {"Parameters", "UnitLength_in_cm"},
                                  {"Parameters", "InternalUnitSystem:UnitLength_in_cgs"},
                                  {"Header", "UnitLength_in_cm"},
                                  {"Header", "UnitLength_In_CGS"}});
  const auto mass = unit(file, {{"Units", "Unit mass in cgs (U_M)"},
                                {"Parameters", "UnitMass_in_g"},
                                {"Parameters", "InternalUnitSystem:UnitMass_in_cgs"},
                                {"Header", "UnitMass_in_g"},
                                {"Header", "UnitMass_In_CGS"}});
  const auto time = unit(file, {{"Units", "Unit time in cgs (U_t)"}});
  const auto velocity = unit(file, {{"Parameters", "UnitVelocity_in_cm_per_s"},
                                    {"Parameters", "InternalUnitSystem:UnitVelocity_in_cgs"},
                                    {"Header", "UnitVelocity_in_cm_per_s"},
                                    {"Header", "UnitVelocity_In_CGS"}});
  for (const char* name : {"Unit current in cgs (U_I)", "Unit temperature in cgs (U_T)"}) unit(file, {{"Units", name}});
  if (!length || !mass || !(time || velocity)) return std::nullopt;
  return Units{*length, *mass, time ? *time : *length / *velocity};
}

/// GADGET and AREPO multiply the box along an axis, GADGET-4 divides it by a power of two.
Array3 stretch(const hdf5::File& file) {
  constexpr const char* factors[] = {"LONG_X", "LONG_Y", "LONG_Z"};
  constexpr const char* halvings[] = {"LONG_X_BITS", "LONG_Y_BITS", "LONG_Z_BITS"};
  Array3 stretch{1, 1, 1};
  for (std::size_t k = 0; k < 3; ++k)
    stretch[k] = number_at(file, {"Config", factors[k]}).value_or(1) *
                 std::exp2(-number_at(file, {"Config", halvings[k]}).value_or(0));
  return stretch;
}

}  // namespace

FileFacts facts_of(const hdf5::File& file) {
  refuse_comoving(file);
  for (const Place& wall : wall_flags)
    if (is_set(file, wall))
      throw InputError(
          fmt::format("{}: {} asks for reflecting walls, which sphk does not have; mirror the gas, in a "
                      "periodic box, and remove it",
                      file.where(), wall.text()));
  return {periodic(file), dimension(file), gamma(file), units(file), stretch(file)};
}

}  // namespace sphk
