// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "src/engine/errors.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/scenes.hpp"
#include "src/scenes/shear_layers.hpp"

namespace sphk {

namespace {

constexpr double even_pressure = 0.6;  // the light gas, rho = 1, has the speed of sound 1 at gamma = 5/3
constexpr double light_speed = 0.11, edge = 0.01, wavelength = 0.5;

/// Kelvin-Helmholtz instability of R10 sec 5.1 and S12 sec 7.5: dense gas in |y| < 1/4.
class KelvinHelmholtz final : public ShearLayers {
 public:
  explicit KelvinHelmholtz(int ratio) : ratio_(ratio) {}
  std::string name() const override { return fmt::format("kh1{}", ratio_); }
  std::string summary() const override {
    return fmt::format("Kelvin-Helmholtz layers of density 1:{} ({}), tau_KH = {:.4f}", ratio_,
                       ratio_ == 2 ? "R10 sec 5" : "S12 sec 7.5", growth_time());
  }
  void declare(Settings& settings) const override {
    ShearLayers::declare(settings);
    declare_choice(settings, "scene.edges", "sharp",
                   "of the layers; soft: density and velocity follow tanh(distance/0.01)", {"sharp", "soft"});
  }
  /// Grid runs of the layers with soft edges, converged with resolution; sharp ones never converge.
  std::vector<Reference> references(const Settings& settings) const override {
    if (ratio_ != 2 || settings.text("scene.edges") != "soft") return {};
    std::vector<Reference> references;
    const auto add = [&](const char* measure, double growth_times, double value) {
      references.push_back({measure, growth_times * growth_time(), value, value});
    };
    add("M", 0.25, 0.0198), add("M", 0.5, 0.0432), add("M", 0.75, 0.0596), add("M", 1, 0.0656);
    add("W", 0.5, 0.112), add("W", 1, 0.197);
    add("crossed", 0.5, 0.098), add("crossed", 1, 0.172);
    return references;
  }
  std::string keys_with_references() const override { return ratio_ == 2 ? "scene.edges=soft" : ""; }
  std::vector<PaperChoice> paper(const Settings& settings) const override {
    const std::string of = ratio_ == 2 ? "R10: " : "S12: ", &scheme = settings.text("sph.scheme");
    std::vector<PaperChoice> choices{{of + "256 particles of the light gas along the box", {"scene.n=256"}},
                                     {of + "a slab in 3D, 8 layers thick", {"scene.dimension=3", "scene.layers=8"}},
                                     {of + "sharp edges", {"scene.edges=sharp"}},
                                     {of + "three growth times", {fmt::format("time.end={}", 3 * growth_time())}}};
    // R10's OSPH takes the temperatures as they are.
    if (ratio_ == 8 || !scheme.starts_with("osph"))
      choices.push_back({of + "temperatures of the density that the kernel measures", {"scene.temperatures=smoothed"}});
    if (ratio_ == 8) {
      choices.push_back({"S12: SPHS, with entropies", {"sph.scheme=SPHS-HCT442"}});
    } else {
      choices.push_back({"R10: OSPH, with energies and steps of the particles' own, beside SPH and TSPH",
                         {"sph.scheme=OSPH-HOCT4-442", "time.steps=individual"}});
    }
    return choices;
  }
  GalleryTile gallery() const override {
    GalleryTile tile{.keys = {"scene.n=64", "scene.dimension=2", "scene.edges=soft"}};
    if (ratio_ == 8) tile.keys.emplace_back("scene.masses=multi");
    tile.keys.push_back(fmt::format("time.end={:.6g}", growth_time()));
    return tile;
  }

 protected:
  Defaults defaults() const override { return {.end = 2 * growth_time(), .snapshots = 8}; }
  LayeredFlow flow(const Settings& settings) const override {
    const bool soft = settings.text("scene.edges") == "soft";
    const auto dense_share = [soft](double y) {  // 1 in the dense gas, 0 in the light one
      const double inwards = 0.25 - std::abs(y);
      return soft ? (1 + std::tanh(inwards / edge)) / 2 : inwards > 0 ? 1.0 : 0.0;
    };
    const double excess = ratio_ - 1;
    return {.lower = -0.5,
            .pressure = even_pressure,
            .rho_light = 1,
            .rho_dense = double(ratio_),
            .interfaces = {-0.25, 0.25},
            .wavelength = wavelength,
            .rho = [=](double y) { return 1 + excess * dense_share(y); },
            .v_x = [=](double y) { return light_speed * (2 * dense_share(y) - 1); },
            .v_y = [](double x, double y) {  // R10 eq 58, with delta v_y / v = 1/8
              constexpr double k = 2 * std::numbers::pi / wavelength;
              const auto near = [y](double interface) { return std::exp(-std::pow(10 * (y - interface), 2)); };
              return shear / 8 * (std::sin(k * (x + wavelength / 2)) * near(0.25) - std::sin(k * x) * near(-0.25));
            }};
  }

  /// The dense gas on a lattice of its own, as near to cubic as its mass allows. R10 refines by 5/4 for 1:2.
  std::vector<Block> equal_mass_blocks(const Block& even) const override {
    const auto [n, rows, layers] = even.counts;
    if (n % 4 != 0) throw InputError(fmt::format("scene.n = {}: the layers need a multiple of 4", n));
    const double finer = even.dimension == 3 && ratio_ == 2 ? 1.25 : std::pow(ratio_, 1.0 / even.dimension);
    Block light = even, dense = even;
    light.counts[1] = rows / 4;
    dense.counts[0] = static_cast<int>(std::lround(n * finer));
    if (even.dimension == 3) dense.counts[2] = static_cast<int>(std::lround(layers * finer));
    const double columns = double(dense.counts[0]) * dense.counts[2];
    dense.counts[1] = static_cast<int>(std::lround(ratio_ * double(even.particles()) / 2 / columns));
    const double total = 2.0 * double(light.particles()) + double(dense.particles());
    light.size[1] = double(light.particles()) / total;
    dense.size[1] = double(dense.particles()) / total;
    light.lower[1] = 0;
    dense.lower[1] = light.size[1];
    Block upper = light;
    upper.lower[1] = light.size[1] + dense.size[1];
    return {light, dense, upper};
  }

 private:
  /// v_1 - v_2: the dense gas has the Mach number 0.11 sqrt(ratio), hence the light gas's speed.
  static constexpr double shear = 2 * light_speed;
  /// tau_KH = 2 pi / w, R10 eq 56.
  double growth_time() const { return (ratio_ + 1) * wavelength / (std::sqrt(double(ratio_)) * shear); }

  int ratio_;
};

}  // namespace

const Scene& kh12_scene = KelvinHelmholtz(2);
const Scene& kh18_scene = KelvinHelmholtz(8);

}  // namespace sphk
