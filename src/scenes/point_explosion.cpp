// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "src/engine/errors.hpp"
#include "src/scenes/block.hpp"
#include "src/scenes/explosion.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/norms.hpp"
#include "src/scenes/scenes.hpp"

namespace sphk {

namespace {

/// Saitoh & Makino (2009): the whole energy starts in a single particle, or in a few, which tells whether its
/// neighbours' time-steps follow.
class PointExplosion final : public Explosion {
 public:
  std::string name() const override { return "point-explosion"; }
  std::string summary() const override { return "all energy in one particle of cold gas (Saitoh & Makino)"; }

  void declare(Settings& settings) const override {
    // A scheme that conserves energy, and a kernel without noise: what is tested are the time-steps.
    prefer_unless_set(settings, "sph.scheme", "gadget2");
    prefer_unless_set(settings, "time.steps", "individual");
    Explosion::declare(settings);
    declare_real(settings, "scene.ambient", 1e-6, "specific thermal energy u of the gas at rest", {.min = 1e-300});
    declare_integer(settings, "scene.hot", 1,
                    "particles around the centre that share the energy, in whole shells of a lattice: 1, 7, 15, 19, 27",
                    {.min = 1, .max = 1e6});
    declare_real(settings, "scene.delay", 0.0,
                 "time at which the energy comes, into gas that has been at rest until then", {.min = 0, .max = 1e300});
  }
  void adapt(Settings& settings) const override {
    if (scene_dimension(settings) != 3) return;
    prefer_unless_set(settings, "sph.kernel", "wc4");
    prefer_unless_set(settings, "sph.neighbours", 200.0);
  }

  std::vector<HeatEvent> heatings(const Settings& settings) const override {
    if (start(settings) == 0) return {};
    const ParticleSet gas = build(settings);
    const std::vector<std::size_t> hot = hottest(gas, settings);
    const double u = energy_of_each(gas, hot, settings);
    std::vector<HeatEvent> events;
    for (const std::size_t i : hot) events.push_back({start(settings), gas.x[i], gas.m[i] * u});
    return events;
  }
  GalleryTile gallery() const override { return {.keys = {"scene.n=24"}, .field = ""}; }

 protected:
  double start(const Settings& settings) const override { return settings.real("scene.delay"); }
  double ambient_pressure(const Settings& settings) const override {
    return (settings.real("sph.gamma") - 1) * settings.real("scene.ambient");
  }

  /// The particles nearest to the centre take the energy, now or later; all gas is shifted so that the nearest sits on
  /// it exactly.
  void explode(ParticleSet& gas, const Settings& settings) const override {
    const Array3 shift = *std::ranges::min_element(gas.x, {}, radius);
    for (Array3& x : gas.x)
      for (int axis = 0; axis < gas.dimension; ++axis)
        x[axis] = gas.box.lower[axis] + wrapped(x[axis] - shift[axis] - gas.box.lower[axis], gas.box.size[axis]);
    if (start(settings) > 0) return;
    const std::vector<std::size_t> hot = hottest(gas, settings);
    const double u = energy_of_each(gas, hot, settings);
    for (const std::size_t i : hot) gas.u[i] += u;
  }

 private:
  /// Specific energy that each of these particles takes.
  static double energy_of_each(const ParticleSet& gas, const std::vector<std::size_t>& hot, const Settings& settings) {
    double mass = 0;
    for (const std::size_t i : hot) mass += gas.m[i];
    return settings.real("scene.energy") / mass;
  }
  /// scene.hot particles around the centre, in whole shells of equal distance, so that the blast has the symmetry of
  /// the lattice. A shell that is too large is passed over: 15 in 3D are 1 + 6 + 8, without the 12 between.
  static std::vector<std::size_t> hottest(const ParticleSet& gas, const Settings& settings) {
    const auto count = static_cast<std::size_t>(settings.integer("scene.hot"));
    std::vector<std::size_t> order(gas.size()), chosen;
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto distance = [&](std::size_t i) { return radius(gas.x[i]); };
    std::ranges::stable_sort(order, {}, distance);
    for (std::size_t from = 0; from < std::min(2 * count, order.size()) && chosen.size() < count;) {
      std::size_t to = from;
      while (to < order.size() && distance(order[to]) <= distance(order[from]) * (1 + 1e-9)) ++to;
      if (to - from <= count - chosen.size()) chosen.insert(chosen.end(), &order[from], &order[from] + (to - from));
      from = to;
    }
    if (chosen.size() < count)
      throw InputError(fmt::format(
          "scene.hot = {}: no whole shells of particles around the centre make up this number; on a lattice take {}",
          count,
          gas.dimension == 1   ? "1, 3 or 5"
          : gas.dimension == 2 ? "1, 5 or 9"
                               : "1, 7, 15, 19 or 27"));
    return chosen;
  }
};

}  // namespace

const Scene& point_explosion_scene = PointExplosion();

}  // namespace sphk
