// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "src/scenes/keys.hpp"
#include "src/scenes/scenes.hpp"
#include "src/scenes/shear_layers.hpp"

namespace sphk {

namespace {

constexpr double ramp = 0.025;

/// `light` and `dense` (between 1/4 and 3/4) joined by exponential ramps, McNally, Lyra & Passy (2012).
double ramped(double light, double dense, double y) {
  const double inwards = 0.25 - std::abs(y - 0.5), half = (light - dense) / 2;
  const double tail = half * std::exp(-std::abs(inwards) / ramp);
  return inwards < 0 ? light - tail : dense + tail;
}

class McNally final : public ShearLayers {
 public:
  std::string name() const override { return "mcnally"; }
  std::string summary() const override { return "smooth shear layers whose growth converges (McNally, Lyra & Passy)"; }
  void declare(Settings& settings) const override {
    ShearLayers::declare(settings);
    declare_arrangement(settings, "cubic");
  }
  /// Grid runs, converged with resolution.
  std::vector<Reference> references(const Settings&) const override {
    std::vector<Reference> references;
    for (const auto& [t, M] : {std::pair{0.5, 0.0105}, {0.75, 0.0229}, {1.0, 0.0475}, {1.5, 0.148}, {2.0, 0.233}})
      references.push_back({"M", t, M, M});
    return references;
  }
  GalleryTile gallery() const override { return {.keys = {"scene.n=96"}}; }

 protected:
  Defaults defaults() const override { return {.n = 128, .dimension = 2, .end = 2, .snapshots = 20}; }
  LayeredFlow flow(const Settings&) const override {
    return {.lower = 0,
            .pressure = 2.5,
            .rho_light = 1,
            .rho_dense = 2,
            .interfaces = {0.25, 0.75},
            .wavelength = 0.5,
            .rho = [](double y) { return ramped(1, 2, y); },
            .v_x = [](double y) { return ramped(0.5, -0.5, y); },
            .v_y = [](double x, double) { return 0.01 * std::sin(4 * std::numbers::pi * x); }};
  }
};

}  // namespace

const Scene& mcnally_scene = McNally();

}  // namespace sphk
