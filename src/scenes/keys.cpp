// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/keys.hpp"

#include <algorithm>

namespace sphk {

void prefer_unless_set(Settings& settings, std::string_view name, const Value& value) {
  if (settings.has(name)) settings.prefer(name, value);
}

void declare_integer(Settings& settings, std::string name, std::int64_t standard, std::string doc, Range range) {
  settings.declare({std::move(name), standard, std::move(doc), {}, range.min, range.max});
}

void declare_real(Settings& settings, std::string name, double standard, std::string doc, Range range) {
  settings.declare({std::move(name), standard, std::move(doc), {}, range.min, range.max});
}

void declare_choice(Settings& settings, std::string name, std::string standard, std::string doc,
                    std::vector<std::string> choices) {
  settings.declare(
      {.name = std::move(name), .value = std::move(standard), .doc = std::move(doc), .choices = std::move(choices)});
}

void declare_resolution(Settings& settings, int n, std::string doc) {
  declare_integer(settings, "scene.n", n, std::move(doc), {.min = 2, .max = 100000});
}

void declare_arrangement(Settings& settings, const std::string& standard) {
  declare_choice(settings, "scene.lattice", standard, "how the particles are laid out; random: each for itself",
                 {"cubic", "glass", "random"});
}

void declare_dimension(Settings& settings, int standard, int min) {
  declare_integer(settings, "scene.dimension", standard, "number of dimensions", {.min = double(min), .max = 3});
}

void declare_masses(Settings& settings, const std::string& standard) {
  declare_choice(settings, "scene.masses", standard,
                 "equal: more particles in the dense gas; multi: even spacing, heavier particles there",
                 {"equal", "multi"});
}

bool has_equal_masses(const Settings& settings) {
  return settings.text("scene.masses") == "equal";
}

void declare_temperatures(Settings& settings) {
  declare_choice(settings, "scene.temperatures", "exact",
                 "exact: u of the true density; smoothed: of the measured one, which evens out P at the edges",
                 {"exact", "smoothed"});
}

void prefer_usual_gas(Settings& settings, double end) {
  prefer_unless_set(settings, "time.end", end);
  prefer_unless_set(settings, "sph.gamma", 5.0 / 3);
}

int scene_n(const Settings& settings) {
  return static_cast<int>(settings.integer("scene.n"));
}

int scene_dimension(const Settings& settings) {
  return static_cast<int>(settings.integer("scene.dimension"));
}

}  // namespace sphk
