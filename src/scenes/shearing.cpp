// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/engine/errors.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/mass_profile.hpp"
#include "src/scenes/scenes.hpp"
#include "src/scenes/shear_layers.hpp"
#include "src/scenes/smooth_layers.hpp"

namespace sphk {

namespace {

constexpr double contrast = 10, pressure = 10, wavelength = 1.0 / 6;
constexpr double boundary_width = 0.5 / 7.5;  // delta of V10 eq 18-19
constexpr int usual_n = 190;                  // V10's series SPH: 190 x 95 light and 602 x 301 dense particles

/// The series of V10 Table 4: what each name stands for.
struct Series {
  const char *name, *kernel, *smoothing;
  double conductivity;
  int n;  ///< LIQ+ has three times the particles
};
constexpr Series series[] = {{"SPH", "cs", "none", 1, usual_n},      {"RHO", "cs", "columns", 1, usual_n},
                             {"LIQ", "liq", "columns", 1, usual_n},  {"GRID", "liq", "rows", 1, usual_n},
                             {"NOAC", "liq", "columns", 0, usual_n}, {"LIQ+", "liq", "columns", 1, 329}};

const Series& series_of(const Settings& settings) {
  return *std::ranges::find(series, settings.text("scene.series"), [](const Series& s) { return std::string(s.name); });
}

/// Shearing layers of density 1:10 (V10 sec 4): dense gas in 1/4 < y < 3/4, u = 15 and 1.5, six wavelengths along x.
class Shearing final : public ShearLayers {
 public:
  std::string name() const override { return "shearing"; }
  std::string summary() const override { return "shearing layers of density 1:10 at Mach 0.2 to 1 (V10 sec 4)"; }
  void declare(Settings& settings) const override {
    std::vector<std::string> names;
    for (const Series& s : series) names.emplace_back(s.name);
    declare_choice(settings, "scene.series", "LIQ",
                   "V10's series: kernel, smoothing and conductivity, for those that are not set", names);
    declare_real(settings, "scene.mach", 0.6, "speed of each gas over the speed of sound of the dense one",
                 {.min = 0, .max = 100});
    declare_real(settings, "scene.seed", 0.025, "amplitude of the disturbance v_y = A sin(2 pi x/lambda) (V10 eq 15)",
                 {.min = -1e6, .max = 1e6});
    declare_real(settings, "scene.seed_reach", 0.0,
                 "how far from an interface it reaches; 0: everywhere, as V10 print it (Price 2008: 0.025)",
                 {.min = 0, .max = 1e6});
    declare_choice(settings, "scene.smoothing", "columns",
                   "of the density: none, along columns, or by rows between square grids (V10 sec 4.3)",
                   {"none", "columns", "rows"});
    ShearLayers::declare(settings);
  }

  void adapt(Settings& settings) const override {
    const Series& s = series_of(settings);
    prefer_unless_set(settings, "scene.dimension", std::int64_t{2});
    prefer_unless_set(settings, "scene.n", std::int64_t{s.n});
    prefer_unless_set(settings, "scene.smoothing", std::string(s.smoothing));
    prefer_unless_set(settings, "sph.scheme", "v10");
    prefer_unless_set(settings, "conductivity.alpha", s.conductivity);
    if (!settings.has("sph.scheme")) return;  // smoothed temperatures need a scheme
    prefer_unless_set(settings, "scene.temperatures", "smoothed");
    prefer_unless_set(settings, "sph.kernel", std::string(s.kernel));
    prefer_unless_set(settings, "sph.neighbours", 32.0);  // V10 sec 3.1
  }

  std::vector<PaperChoice> paper(const Settings&) const override {
    return {{"V10: steps of the particles' own", {"time.steps=individual"}},
            {"V10: in 2D", {"scene.dimension=2"}},
            {"V10: GADGET-2 with conductivity", {"sph.scheme=v10"}},
            {"V10: u from the measured density and an even pressure", {"scene.temperatures=smoothed"}}};
  }
  GalleryTile gallery() const override {
    return {.keys = {"scene.n=64", "scene.mach=0.2", "sph.scheme=sphs", "sph.kernel=wc6", "sph.neighbours=100",
                     "time.end=1.684"}};
  }

 protected:
  Defaults defaults() const override { return {.n = usual_n, .dimension = 2, .end = 2, .snapshots = 16}; }
  LayeredFlow flow(const Settings& settings) const override {
    const bool sharp = settings.text("scene.smoothing") == "none";
    const double speed = settings.real("scene.mach") * std::sqrt(settings.real("sph.gamma") * pressure / contrast);
    const double seed = settings.real("scene.seed"), reach = settings.real("scene.seed_reach");
    const auto inwards = [](double y) { return 0.25 - std::abs(y - 0.5); };
    return {.lower = 0,
            .pressure = pressure,
            .rho_light = 1,
            .rho_dense = contrast,
            .interfaces = {0.25, 0.75},
            .wavelength = wavelength,
            .rho =
                [=](double y) {
                  return 1 +
                         (contrast - 1) * (sharp ? double(inwards(y) > 0) : arctan_step(inwards(y), boundary_width));
                },
            .v_x = [=](double y) { return inwards(y) > 0 ? speed : -speed; },
            .v_y =
                [=](double x, double y) {
                  const bool seeded = reach == 0 || std::abs(inwards(y)) < reach;
                  return seeded ? seed * std::sin(2 * std::numbers::pi / wavelength * x) : 0;
                }};
  }

  /// As many particles as V10 have at n = 190: 199252 on two grids, 184100 on 350 columns.
  void place_equal_masses(ParticleSet& gas, const LayeredFlow& flow, const Settings& settings) const override {
    if (scene_dimension(settings) != 2)
      throw InputError(
          "scene.dimension = 3: equal masses of this scene are laid out in 2D alone; scene.masses = \"multi\" can");
    const int light = 2 * std::max(1, scene_n(settings) / 2), dense = 2 * int(std::lround(light * 301.0 / usual_n));
    const std::string& smoothing = settings.text("scene.smoothing");
    const Array3 size{1, 1, 1};
    if (smoothing == "columns") {
      gas.x = columns_of(flow.rho, {}, size, int(std::lround(light * 350.0 / usual_n)),
                         int(std::lround(light * 526.0 / usual_n)));
    } else if (smoothing == "rows") {
      gas.x = rows_of(flow.rho, {}, size, (light * light + double(dense) * dense) / 2);
    } else {
      const auto add = [&](int along, double from, double to) {
        const int rows = int(std::lround(along * (to - from)));
        add_block(gas, {2, {along, rows, 1}, {0, from, 0}, {1, to - from, 1}}, "cubic");
      };
      add(light, 0, 0.25);
      add(dense, 0.25, 0.75);
      add(light, 0.75, 1);
    }
    const double mass = MassProfile(flow.rho, 0, 1).mass();
    gas.m.assign(gas.size(), mass / double(gas.size()));
  }
};

}  // namespace

const Scene& shearing_scene = Shearing();

}  // namespace sphk
