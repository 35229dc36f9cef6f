// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "src/engine/settings.hpp"

namespace sphk {

/// Changes the default of an engine key, where there is such a key and neither a file nor the command line set it.
void prefer_unless_set(Settings& settings, std::string_view name, const Value& value);

/// Limits of a key's value.
struct Range {
  double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();
};
/// A key of that type, with its default.
void declare_integer(Settings& settings, std::string name, std::int64_t standard, std::string doc, Range range = {});
void declare_real(Settings& settings, std::string name, double standard, std::string doc, Range range = {});
void declare_choice(Settings& settings, std::string name, std::string standard, std::string doc,
                    std::vector<std::string> choices);

/// scene.n: particles per unit length of the (denser) gas.
void declare_resolution(Settings& settings, int n, std::string doc = "particles per unit length");
/// scene.lattice: cubic | glass | random.
void declare_arrangement(Settings& settings, const std::string& standard);
/// scene.dimension: `min` to 3.
void declare_dimension(Settings& settings, int standard, int min = 1);

/// scene.masses: equal (the dense gas has more particles) | multi (even spacing, heavier particles).
void declare_masses(Settings& settings, const std::string& standard);
bool has_equal_masses(const Settings& settings);
/// scene.temperatures: exact | smoothed (initial_condition.hpp).
void declare_temperatures(Settings& settings);
/// gamma = 5/3 and this end time, where the user set neither.
void prefer_usual_gas(Settings& settings, double end);

int scene_n(const Settings& settings);
int scene_dimension(const Settings& settings);

}  // namespace sphk
