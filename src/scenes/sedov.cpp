// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "src/engine/errors.hpp"
#include "src/scenes/explosion.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/norms.hpp"
#include "src/scenes/scenes.hpp"

namespace sphk {

namespace {

class Sedov final : public Explosion {
 public:
  std::string name() const override { return "sedov"; }
  std::string summary() const override { return "point explosion: strong shock, entropy contrast (S12 sec 7.4)"; }

  void declare(Settings& settings) const override {
    Explosion::declare(settings);
    declare_real(settings, "scene.blast_radius", 0.08, "the energy is shared by the particles inside (S12 sec 7.4)",
                 {.min = 0, .max = 0.5});
    declare_real(settings, "scene.ambient_entropy", 0.05, "A = P / rho^gamma of the gas at rest", {.min = 1e-300});
  }
  std::vector<PaperChoice> paper(const Settings&) const override {
    return {{"S12: SPHS, and SPH with 42 neighbours and steps of the particles' own", {"sph.scheme=SPHS-HCT442"}}};
  }
  GalleryTile gallery() const override {
    return {.keys = {"scene.n=48", "sph.scheme=sphs-conservative", "sph.kernel=hoct4", "sph.neighbours=442"}};
  }

 protected:
  /// P = A rho^gamma at rho = 1.
  double ambient_pressure(const Settings& settings) const override { return settings.real("scene.ambient_entropy"); }

  void explode(ParticleSet& gas, const Settings& settings) const override {
    const double blast_radius = settings.real("scene.blast_radius");
    double mass = 0;
    for (std::size_t i = 0; i < gas.size(); ++i)
      if (radius(gas.x[i]) < blast_radius) mass += gas.m[i];
    if (mass == 0)
      throw InputError(fmt::format("scene.blast_radius = {}: no particle lies so close to the centre; take at least {}",
                                   blast_radius, 1.0 / scene_n(settings)));
    for (std::size_t i = 0; i < gas.size(); ++i)
      if (radius(gas.x[i]) < blast_radius) gas.u[i] += settings.real("scene.energy") / mass;
  }
};

}  // namespace

const Scene& sedov_scene = Sedov();

}  // namespace sphk
