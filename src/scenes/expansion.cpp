// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "src/engine/geometry.hpp"
#include "src/scenes/block.hpp"
#include "src/scenes/homologous.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/mass_profile.hpp"
#include "src/scenes/norms.hpp"
#include "src/scenes/scenes.hpp"

namespace sphk {

namespace {

bool is_slab(const Settings& settings) {
  return settings.text("scene.variant") == "slab";
}

/// Even gas at rest in |x| < 0.5, with rho = c = 1. From both faces a rarefaction runs inwards at the speed of sound
/// and the first gas outwards at 2/(gamma-1) (Toro 2009, sec 4.6); between them, with a = (|x| - 0.5)/t,
/// v = 2/(gamma+1) (1 + a) and c = 1 - (gamma-1)/2 v. Exact until the rarefactions meet in the middle, at t = 0.5.
GasState slab(const Array3& x, double t, double gamma) {
  const double beyond = std::abs(x[0]) - 0.5;
  if (beyond < -t) return {1, {}, 1 / gamma};
  if (beyond >= 2 / (gamma - 1) * t) return {0, {}, 0};
  const double v = 2 / (gamma + 1) * (1 + beyond / t), rho = std::pow(1 - (gamma - 1) / 2 * v, 2 / (gamma - 1));
  return {rho, {std::copysign(v, x[0]), 0, 0}, std::pow(rho, gamma) / gamma};
}

/// Gas that expands into vacuum from rest: density and pressure fall without end, and no shock should form.
class Expansion final : public Scene {
 public:
  std::string name() const override { return "expansion"; }
  std::string summary() const override { return "gas that expands into vacuum: an isentropic ball, or a slab"; }

  void declare(Settings& settings) const override {
    declare_choice(settings, "scene.variant", "ball",
                   "ball: isentropic, expands as a whole; slab: rarefactions from two faces", {"ball", "slab"});
    declare_resolution(settings, 16, "particles per unit length: along the radius of the ball, through the slab");
    declare_dimension(settings, 3);
    declare_arrangement(settings, "cubic");
    declare_integer(settings, "scene.across", 8, "particles across the slab, in 2D and 3D", {.min = 1, .max = 10000});
    prefer_unless_set(settings, "sph.gamma", 5.0 / 3);
    adapt(settings);
  }

  /// The ball ends at about five times its radius. Support radii grow as the gas thins, without end where
  /// particles stray at the edge: ten times that of even gas at the start is about twice that of the centre at the end.
  void adapt(Settings& settings) const override {
    const int D = scene_dimension(settings);
    prefer_unless_set(settings, "time.end", is_slab(settings) ? 0.4 : 2 + 0.28 * D);
    const double h = std::pow(settings.real("sph.neighbours") / unit_sphere_volume(D), 1.0 / D) / scene_n(settings);
    prefer_unless_set(settings, "sph.h_max", 10 * h);
  }

  ParticleSet build(const Settings& settings) const override {
    ParticleSet gas = is_slab(settings) ? even_slab(settings) : ball(settings);
    const auto start = exact(settings);
    for (const Array3& x : gas.x) gas.u.push_back(start(x, 0).u(settings.real("sph.gamma")));
    gas.v.assign(gas.size(), {});
    return gas;
  }

  ExactSolution exact(const Settings& settings) const override {
    const double gamma = settings.real("sph.gamma");
    if (is_slab(settings)) return [=](const Array3& x, double t) { return slab(x, t, gamma); };
    const HomologousExpansion expansion(scene_dimension(settings), gamma);
    return [=, time = 0.0, R = 1.0](const Array3& x, double t) mutable {
      if (t != time) R = expansion.outer_radius(time = t);  // once for all places of a time
      return expansion.at(x, R);
    };
  }

  /// Inside 0.8 of the ball's radius; of the slab inside |x| < 1, where it has at least 8 % of its density at t = 0.4.
  Errors errors(const Settings& settings, const Snapshot& snapshot) const override {
    const double to = reach(settings, snapshot.time);
    return profile_errors(snapshot, is_slab(settings) ? along_x(-to, to) : along_r(to), exact(settings));
  }
  /// There: rms of the relative error of the particles' densities.
  Measures measures(const Settings& settings, const Snapshot& snapshot) const override {
    const auto solution = exact(settings);
    const double to = reach(settings, snapshot.time);
    const auto x = rows(snapshot.field("Coordinates"));
    const auto& rho = snapshot.field("Densities").values;
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < snapshot.size(); ++i) {
      const double wanted = solution(x[i], snapshot.time).rho;
      if (!(wanted > 0) || (is_slab(settings) ? std::abs(x[i][0]) : radius(x[i])) > to) continue;
      sum += std::pow(rho[i] / wanted - 1, 2);
      ++count;
    }
    return {{"density_error", count > 0 ? std::sqrt(sum / count) : 0}};
  }
  PlotHint plot_hint(const Settings& settings) const override {
    const double to = reach(settings, settings.real("time.end"));
    if (is_slab(settings)) return {.abscissa = "x", .from = -to, .to = to};
    return {.abscissa = "r", .from = 0, .to = to};
  }

 private:
  static double reach(const Settings& settings, double t) {
    const HomologousExpansion expansion(scene_dimension(settings), settings.real("sph.gamma"));
    return is_slab(settings) ? 1 : 0.8 * expansion.outer_radius(t);
  }

  static ParticleSet even_slab(const Settings& settings) {
    const int D = scene_dimension(settings), n = scene_n(settings);
    const int across = static_cast<int>(settings.integer("scene.across"));
    ParticleSet gas = even_gas(bar(D, n, across, -0.5, 1), settings.text("scene.lattice"));
    gas.box.periodic[0] = false;
    return gas;
  }

  /// Even gas of the unit ball, every particle moved along its radius to where the profile has as much mass inside.
  static ParticleSet ball(const Settings& settings) {
    const int D = scene_dimension(settings), n = scene_n(settings);
    const HomologousExpansion expansion(D, settings.real("sph.gamma"));
    const MassProfile profile([&](double r) { return expansion.at({r, 0, 0}, 1).rho * std::pow(r, D - 1); }, 0, 1);
    const Block block = centred_cube(D, 2 * n, 1);
    ParticleSet gas;
    gas.dimension = D;
    gas.box = {block.lower, block.size, {}};
    for (Array3 x : arranged_points(block, settings.text("scene.lattice"))) {
      const double q = radius(x);
      if (q >= 1) continue;
      const double stretch = q > 0 ? profile.place(std::pow(q, D)) / q : 1;
      for (double& s : x) s *= stretch;
      gas.x.push_back(x);
    }
    gas.m.assign(gas.size(), D * unit_sphere_volume(D) * profile.mass() / double(gas.size()));
    return gas;
  }
};

}  // namespace

const Scene& expansion_scene = Expansion();

}  // namespace sphk
