#include <algorithm>
#include <cmath>

#include "src/scenes/block.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/norms.hpp"
#include "src/scenes/scenes.hpp"
#include "src/scenes/temperatures.hpp"

namespace sphk {

namespace {

constexpr double pressure = 2.5;

/// Dense gas in the middle half of a periodic box, in pressure balance with the thin gas around it (Saitoh & Makino
/// 2013, sec 5.3): it keeps its shape, at rest, in motion, and where the masses of the particles jump.
class Square final : public Scene {
 public:
  std::string name() const override { return "square"; }
  std::string summary() const override {
    return "a dense square in pressure balance: no motion, no blips of the pressure";
  }

  void declare(Settings& settings) const override {
    declare_resolution(settings, 32, "particles of the thin gas along the unit box; a multiple of 4");
    declare_dimension(settings, 2, 2);
    settings.declare({.name = "scene.ratio",
                      .value = 4.0,
                      .doc = "density of the dense gas over that of the thin",
                      .choices = {},
                      .min = 1,
                      .max = 1e9});
    declare_masses(settings, "multi");
    declare_temperatures(settings);
    settings.declare({.name = "scene.boost", .value = 0.0, .doc = "speed of all gas along x and y", .choices = {}});
    prefer_unless_set(settings, "sph.scheme", "sphs");
    prefer_usual_gas(settings, 1);
    adapt(settings);
  }
  void adapt(Settings& settings) const override {
    prefer_usual_kernel(settings, scene_dimension(settings));
    prefer_conserved_energy(settings);
  }

  /// Equal masses: the dense gas on a lattice that is finer by the nearest whole number of particles a side.
  ParticleSet build(const Settings& settings) const override {
    const int D = scene_dimension(settings), n = scene_n(settings);
    const double ratio = settings.real("scene.ratio"), boost = settings.real("scene.boost");
    const bool equal = has_equal_masses(settings);
    const int fine = static_cast<int>(std::lround(n / 2 * (equal ? std::pow(ratio, 1.0 / D) : 1)));
    Block thin{.dimension = D, .counts = even_counts(D, n)}, dense{.dimension = D, .counts = even_counts(D, fine)};
    for (int axis = 0; axis < D; ++axis) dense.lower[axis] = 0.25, dense.size[axis] = 0.5;
    ParticleSet gas;
    gas.dimension = D;
    gas.box = {thin.lower, thin.size, {true, true, D > 2}};
    const auto add = [&](const Array3& x, double rho, double volume) {
      gas.x.push_back(x);
      gas.v.push_back({boost, boost, 0});
      gas.m.push_back(rho * volume);
      gas.u.push_back(pressure / ((settings.real("sph.gamma") - 1) * rho));
    };
    for (const Array3& x : lattice_points(thin))
      if (!inside(x, D)) add(x, 1, std::pow(1.0 / n, D));
    for (const Array3& x : lattice_points(dense)) add(x, ratio, std::pow(0.5 / fine, D));
    smooth_temperatures(gas, pressure, settings);
    return gas;
  }

  std::function<GasState(const Array3&, double)> exact(const Settings& settings) const override {
    const int D = scene_dimension(settings);
    const double ratio = settings.real("scene.ratio"), boost = settings.real("scene.boost");
    return [=](const Array3& x, double t) -> GasState {
      Array3 start = x;
      for (int axis = 0; axis < 2; ++axis) start[axis] = wrapped(x[axis] - boost * t, 1);
      return {inside(start, D) ? ratio : 1, {boost, boost, 0}, pressure};
    };
  }
  /// Of the particles: largest distance from the pressure, over it, and largest speed beside the boost over the speed
  /// of sound of the dense gas.
  std::vector<std::pair<std::string, double>> measures(const Settings& settings,
                                                       const Snapshot& snapshot) const override {
    const double boost = settings.real("scene.boost"),
                 c = std::sqrt(settings.real("sph.gamma") * pressure / settings.real("scene.ratio"));
    const auto &P = snapshot.field("Pressures").values, &v = snapshot.field("Velocities").values;
    double blip = 0, speed = 0;
    for (std::size_t i = 0; i < snapshot.size(); ++i) {
      blip = std::max(blip, std::abs(P[i] / pressure - 1));
      speed = std::max(speed, std::hypot(v[3 * i] - boost, v[3 * i + 1] - boost, v[3 * i + 2]));
    }
    return {{"pressure_error", blip}, {"mach", speed / c}};
  }
  PlotHint plot_hint(const Settings&) const override { return {.abscissa = "x", .from = 0, .to = 1, .map = true}; }

 private:
  static bool inside(const Array3& x, int D) {
    for (int axis = 0; axis < D; ++axis)
      if (!(x[axis] > 0.25 && x[axis] < 0.75)) return false;
    return true;
  }
};

}  // namespace

const Scene& square_scene() {
  static const Square scene;
  return scene;
}

}  // namespace sphk
