// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/engine/settings.hpp"
#include "src/io/units.hpp"

namespace sphk {

/// Declares the keys of the section [units], each "code" where nobody says more.
void declare_unit_keys(Settings& settings);

/// Takes a file's units over, where the user asks for no others.
void prefer_units(Settings& settings, const Units& units);

/// A value for a key of [units], where a number may stand for its text; any other key's value as it is. Throws
/// InputError for what is no unit.
Value checked_unit(const std::string& key, const Value& value);

/// Lets a velocity that the user asks for take the place of a file's unit of time, and throws InputError where the
/// units do not make a whole: one of length, one of mass, and one of time or of velocity.
void settle_units(Settings& settings);

/// The units of the run; none: code units.
std::optional<Units> units_of(const Settings& settings);

/// What is to be said of them: which they are, and that a file's numbers are not converted where it says others.
std::vector<std::string> unit_remarks(const std::optional<Units>& units, const std::optional<Units>& of_file);

}  // namespace sphk
