#include <algorithm>

#include "src/scenes/block.hpp"
#include "src/scenes/explosion.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/norms.hpp"
#include "src/scenes/scenes.hpp"

namespace sphk {

namespace {

/// Saitoh & Makino (2009): the whole energy starts in a single particle, which tells whether its neighbours' time-steps
/// follow.
class PointExplosion final : public Explosion {
 public:
  std::string name() const override { return "point-explosion"; }
  std::string summary() const override { return "all energy in one particle of cold gas (Saitoh & Makino)"; }

  void declare(Settings& settings) const override {
    // A scheme that conserves energy, and a kernel without noise: what is tested are the time-steps.
    prefer_unless_set(settings, "sph.scheme", "gadget2");
    prefer_unless_set(settings, "time.steps", "individual");
    Explosion::declare(settings);
    settings.declare({.name = "scene.ambient",
                      .value = 1e-6,
                      .doc = "specific thermal energy u of the gas at rest",
                      .choices = {},
                      .min = 1e-300});
  }
  void adapt(Settings& settings) const override {
    Explosion::adapt(settings);
    if (settings.has("sph.scheme") && settings.text("sph.scheme") == "gadget2" && scene_dimension(settings) == 3) {
      prefer_unless_set(settings, "sph.kernel", "wc4");
      prefer_unless_set(settings, "sph.neighbours", 200.0);
    }
  }

 protected:
  double ambient_pressure(const Settings& settings) const override {
    return (settings.real("sph.gamma") - 1) * settings.real("scene.ambient");
  }

  /// The particle nearest to the centre takes the energy; all gas is shifted so that it sits on the centre exactly.
  void explode(ParticleSet& gas, const Settings& settings) const override {
    const auto nearest = std::ranges::min_element(gas.x, {}, radius);
    const auto one = static_cast<std::size_t>(nearest - gas.x.begin());
    gas.u[one] += settings.real("scene.energy") / gas.m[one];
    const Array3 shift = *nearest;
    for (Array3& x : gas.x)
      for (int axis = 0; axis < gas.dimension; ++axis)
        x[axis] = gas.box.lower[axis] + wrapped(x[axis] - shift[axis] - gas.box.lower[axis], gas.box.size[axis]);
  }
};

}  // namespace

const Scene& point_explosion_scene() {
  static const PointExplosion scene;
  return scene;
}

}  // namespace sphk
