#include "src/scenes/keys.hpp"

#include <algorithm>

namespace sphk {

void prefer_unless_set(Settings& settings, std::string_view name, const Value& value) {
  const auto key = std::ranges::find(settings.keys(), name, &Key::name);
  if (key == settings.keys().end() || key->origin == Origin::file || key->origin == Origin::command_line) return;
  settings.prefer(name, value);
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

void prefer_usual_gas(Settings& settings, double end) {
  prefer_unless_set(settings, "time.end", end);
  prefer_unless_set(settings, "sph.gamma", 5.0 / 3);
}

void prefer_usual_kernel(Settings& settings, int dimension) {
  const bool sphs = settings.has("sph.scheme") && settings.text("sph.scheme").starts_with("sphs");
  // S12's kernel and neighbours in 3D, the same radius in 1D; in 2D WC6 grows layers closer to grid runs.
  if (sphs) prefer_unless_set(settings, "sph.kernel", dimension == 2 ? "wc6" : "hoct4");
  const double wide = dimension == 1 ? 10 : dimension == 2 ? 100 : 442;
  prefer_unless_set(settings, "sph.neighbours", sphs ? wide : usual_neighbours(dimension));
}

void prefer_conserved_energy(Settings& settings) {
  const bool sphs = settings.has("sph.scheme") && settings.text("sph.scheme") == "sphs";
  prefer_unless_set(settings, "sph.energy", sphs ? "energy" : "entropy");
}

double usual_neighbours(int dimension) {
  return dimension == 1 ? 5 : dimension == 2 ? 20 : 48;
}

int scene_n(const Settings& settings) {
  return static_cast<int>(settings.integer("scene.n"));
}

int scene_dimension(const Settings& settings) {
  return static_cast<int>(settings.integer("scene.dimension"));
}

}  // namespace sphk
