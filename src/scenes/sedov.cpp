#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "src/engine/errors.hpp"
#include "src/scenes/block.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/norms.hpp"
#include "src/scenes/scenes.hpp"
#include "src/scenes/sedov_solution.hpp"

namespace sphk {

namespace {

constexpr double density = 1;

/// Pressure of the gas at rest: P = A rho^gamma at rho = 1.
double ambient_pressure(const Settings& settings) { return settings.real("scene.ambient_entropy"); }

class Sedov : public Scene {
 public:
  std::string name() const override { return "sedov"; }
  std::string summary() const override { return "point explosion: strong shock, entropy contrast (S12 sec 7.4)"; }

  void declare(Settings& settings) const override {
    declare_resolution(settings, 64, "particles along the unit box");
    declare_dimension(settings, 3);
    declare_arrangement(settings, "cubic");
    settings.declare({.name = "scene.energy", .value = 1.0, .doc = "energy of the explosion", .choices = {},
                      .min = 1e-300});
    settings.declare({.name = "scene.blast_radius", .value = 0.08,
                      .doc = "the energy is shared by the particles inside (S12 sec 7.4)", .choices = {}, .min = 0,
                      .max = 0.5});
    settings.declare({.name = "scene.ambient_entropy", .value = 0.05, .doc = "A = P / rho^gamma of the gas at rest",
                      .choices = {}, .min = 1e-300});
    prefer_unless_set(settings, "time.end", 0.05);
    prefer_unless_set(settings, "sph.gamma", 5.0 / 3);
    adapt(settings);
  }
  void adapt(Settings& settings) const override {
    prefer_unless_set(settings, "sph.neighbours", usual_neighbours(scene_dimension(settings)));
  }

  ParticleSet build(const Settings& settings) const override {
    const int D = scene_dimension(settings), n = scene_n(settings);
    Block block{.dimension = D, .counts = even_counts(D, n)};
    for (int axis = 0; axis < D; ++axis) block.lower[axis] = -0.5;
    ParticleSet gas;
    gas.dimension = D;
    gas.box = {block.lower, block.size, {true, D > 1, D > 2}};
    gas.x = arranged_points(block, settings.text("scene.lattice"));
    gas.v.assign(gas.size(), {});
    gas.m.assign(gas.size(), density / double(gas.size()));
    gas.u.assign(gas.size(), ambient_pressure(settings) / ((settings.real("sph.gamma") - 1) * density));
    explode(gas, settings);
    return gas;
  }

  std::function<GasState(const Array3&, double)> exact(const Settings& settings) const override {
    const double E = settings.real("scene.energy"), P = ambient_pressure(settings);
    const auto solution = std::make_shared<SedovSolution>(scene_dimension(settings), settings.real("sph.gamma"));
    return [=](const Array3& x, double t) -> GasState {
      const double r = radius(x);
      if (t <= 0 || r >= solution->shock_radius(E, density, t)) return {density, {}, P};
      GasState state = solution->behind_shock(r, E, density, t);
      const double v = state.v[0] / std::max(r, 1e-300);
      state.v = {v * x[0], v * x[1], v * x[2]};
      return state;
    };
  }
  std::map<std::string, ErrorNorm> errors(const Settings& settings, const Snapshot& snapshot) const override {
    return profile_errors(snapshot, along_r(0.5), exact(settings));
  }
  /// peak_density: (gamma+1)/(gamma-1) when resolved, 4 for gamma 5/3.
  std::vector<std::pair<std::string, double>> measures(const Settings&, const Snapshot& snapshot) const override {
    return {{"peak_density", std::ranges::max(snapshot.field("Densities").values)}};
  }
  PlotHint plot_hint(const Settings&) const override { return {.abscissa = "r", .from = 0, .to = 0.5}; }

 private:
  static void explode(ParticleSet& gas, const Settings& settings) {
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

const Scene& sedov_scene() {
  static const Sedov scene;
  return scene;
}

}  // namespace sphk
