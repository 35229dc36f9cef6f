#include <cmath>

#include "src/scenes/block.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/norms.hpp"
#include "src/scenes/scenes.hpp"

namespace sphk {

namespace {

/// Noh (1987): cold gas of density 1 falls with speed 1 onto the centre; a shock runs outwards at (gamma-1)/2.
GasState noh(const Array3& x, double t, int D, double gamma, double cold_pressure) {
  const double r = radius(x), jump = (gamma + 1) / (gamma - 1);
  if (r < (gamma - 1) / 2 * t) {
    const double rho = std::pow(jump, D);
    return {rho, {}, (gamma - 1) * rho / 2};  // all the kinetic energy, 1/2 per mass, became heat
  }
  const double rho = r > 0 ? std::pow(1 + t / r, D - 1) : 1, towards = r > 0 ? -1 / r : 0;
  return {rho, {towards * x[0], towards * x[1], towards * x[2]}, cold_pressure * std::pow(rho, gamma)};
}

class Noh : public Scene {
 public:
  std::string name() const override { return "noh"; }
  std::string summary() const override { return "cold gas falls onto its centre: infinite Mach number, wall heating"; }

  void declare(Settings& settings) const override {
    declare_resolution(settings, 50, "particles per unit length; the gas fills the unit ball, 2n across");
    declare_dimension(settings, 3);
    declare_arrangement(settings, "cubic");
    settings.declare({.name = "scene.cold_pressure", .value = 1e-6, .doc = "pressure of the cold gas at the start",
                      .choices = {}, .min = 1e-300});
    prefer_usual_gas(settings, 0.6);
    adapt(settings);
  }
  void adapt(Settings& settings) const override {
    prefer_usual_kernel(settings, scene_dimension(settings));
  }

  ParticleSet build(const Settings& settings) const override {
    const int D = scene_dimension(settings), n = scene_n(settings);
    Block block{.dimension = D, .counts = even_counts(D, 2 * n)};
    ParticleSet gas;
    gas.dimension = D;
    for (int axis = 0; axis < D; ++axis) block.lower[axis] = -1, block.size[axis] = 2;
    gas.box = {block.lower, block.size, {}};
    for (const Array3& x : arranged_points(block, settings.text("scene.lattice")))
      if (radius(x) < 1) gas.x.push_back(x);
    const double P = settings.real("scene.cold_pressure"), gamma = settings.real("sph.gamma");
    for (const Array3& x : gas.x) gas.v.push_back(noh(x, 0, D, gamma, P).v);
    gas.m.assign(gas.size(), std::pow(1.0 / n, D));
    gas.u.assign(gas.size(), P / (gamma - 1));
    return gas;
  }

  std::function<GasState(const Array3&, double)> exact(const Settings& settings) const override {
    const int D = scene_dimension(settings);
    const double gamma = settings.real("sph.gamma"), P = settings.real("scene.cold_pressure");
    return [=](const Array3& x, double t) { return noh(x, t, D, gamma, P); };
  }
  /// Inside 3/4 of the radius that the edge has fallen to: the outermost particles miss neighbours on one side.
  std::map<std::string, ErrorNorm> errors(const Settings& settings, const Snapshot& snapshot) const override {
    return profile_errors(snapshot, along_r(0.75 * (1 - snapshot.time)), exact(settings));
  }
  PlotHint plot_hint(const Settings&) const override { return {.abscissa = "r", .from = 0, .to = 0.4}; }
};

}  // namespace

const Scene& noh_scene() {
  static const Noh scene;
  return scene;
}

}  // namespace sphk
