// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "src/scenes/block.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/random.hpp"
#include "src/scenes/scenes.hpp"

namespace sphk {

namespace {

constexpr double far_away = 1e6;      // in box lengths
constexpr double escape_speed = 1e3;  // in sound speeds
constexpr double pressure = 1;        // where the density is 1

/// A lattice whose particles are shifted by up to 0.2 spacings along each axis.
std::vector<Array3> shaken_points(int n) {
  std::vector<Array3> points = lattice_points({.dimension = 3, .counts = even_counts(3, n)});
  Uniform uniform(1);
  for (Array3& x : points)
    for (double& s : x) s += 0.2 / n * (2 * uniform() - 1);
  return points;
}

/// Arrangements of particles that break codes: places that coincide, supports without neighbours or with all of them on
/// a line or plane, and a particle that gets away.
class Odd final : public Scene {
 public:
  std::string name() const override { return "odd"; }
  std::string summary() const override { return "odd arrangements: coincident, collapsed, alone, far apart, ejected"; }

  void declare(Settings& settings) const override {
    declare_choice(settings, "scene.problem", "pair",
                   "pair or ten (at one place), plane (a box collapsed onto it), one (particle), two (1e6 boxes "
                   "apart), ejected (one leaves at 1e3 times c), line (all on it)",
                   {"pair", "ten", "plane", "one", "two", "ejected", "line"});
    declare_resolution(settings, 8, "particles along the unit box");
    adapt(settings);
  }
  void adapt(Settings& settings) const override { prefer_usual_gas(settings, 0.1); }

  ParticleSet build(const Settings& settings) const override {
    const std::string& problem = settings.text("scene.problem");
    const double gamma = settings.real("sph.gamma");
    ParticleSet gas;
    gas.x = places(problem, scene_n(settings));
    if (problem == "two") gas.box.size[0] = 2 * far_away;
    if (problem == "pair" || problem == "ten" || problem == "plane") gas.box.periodic = {true, true, true};
    gas.v.assign(gas.size(), {});
    gas.m.assign(gas.size(), 1 / static_cast<double>(gas.size()));
    gas.u.assign(gas.size(), GasState{.rho = 1, .P = pressure}.u(gamma));
    if (problem == "ejected") gas.v.back()[0] = escape_speed * std::sqrt(gamma * pressure);
    return gas;
  }

  PlotHint plot_hint(const Settings&) const override { return {.map = true}; }
  GalleryTile gallery() const override { return {.keys = {"scene.problem=ten", "scene.n=16"}}; }

 private:
  static std::vector<Array3> places(const std::string& problem, int n) {
    if (problem == "one") return {{0.5, 0.5, 0.5}};
    if (problem == "two") return {{0, 0, 0}, {far_away, 0, 0}};
    std::vector<Array3> points = shaken_points(n);
    if (problem == "pair" || problem == "ten")
      std::fill_n(points.begin(), std::min<std::size_t>(points.size(), problem == "ten" ? 10 : 2), points.front());
    if (problem == "plane")
      for (Array3& x : points) x[2] = 0.5;
    if (problem == "line") {
      points.resize(static_cast<std::size_t>(n) * n);
      for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = {(static_cast<double>(i) + 0.5) / static_cast<double>(points.size()), 0.5, 0.5};
    }
    return points;
  }
};

}  // namespace

const Scene& odd_scene = Odd();

}  // namespace sphk
