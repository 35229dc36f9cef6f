// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/scenes/keys.hpp"
#include "src/scenes/mass_profile.hpp"
#include "src/scenes/norms.hpp"
#include "src/scenes/scenes.hpp"

namespace sphk {

namespace {

constexpr double middle = 1, width = 0.125;  ///< of the ring
constexpr double inner = middle - 3 * width, outer = middle + 3 * width;

/// Surface density of the ring, after the one of Cullen & Dehnen (2010), scaled to radius 1.
double density(double R) {
  const double s = (R - middle) / width;
  return std::exp(-0.5 * s * s);
}

/// What an integral over the ring's area has at R.
double per_radius(double R) {
  return 2 * std::numbers::pi * R * density(R);
}

/// Mean of R and its rms deviation, weighted with w.
struct Spread {
  double sum = 0, first = 0, second = 0;
  void add(double R, double w) { sum += w, first += w * R, second += w * R * R; }
  double mean() const { return first / sum; }
  double deviation() const { return std::sqrt(std::max(second / sum - mean() * mean(), 0.0)); }
};

Spread spread_at_start() {
  Spread spread;
  constexpr int points = 4000;
  for (int k = 0; k < points; ++k) {
    const double R = inner + (k + 0.5) / points * (outer - inner);
    spread.add(R, per_radius(R));
  }
  return spread;
}

/// A cold ring circles a mass: shear without compression, so that viscosity has nothing to do and particles must keep
/// their order (Cullen & Dehnen 2010).
class Ring final : public Scene {
 public:
  std::string name() const override { return "ring"; }
  std::string summary() const override { return "a cold ring circles a mass: no viscosity in shear (Cullen & Dehnen)"; }

  void declare(Settings& settings) const override {
    declare_resolution(settings, 64, "particles per unit length where the ring of radius 1 is densest");
    declare_real(settings, "scene.mach", 100.0, "Mach number of the motion at radius 1", {.min = 5, .max = 1e6});
    prefer_unless_set(settings, "gravity.central_mass", 1.0);
    prefer_unless_set(settings, "sph.scheme", "sphs");
    prefer_usual_gas(settings, 10 * std::numbers::pi);  // five orbits at radius 1
  }
  int dimension(const Settings&) const override { return 2; }

  /// Equal masses on circles, each with as many particles as make their distances along it and across alike.
  ParticleSet build(const Settings& settings) const override {
    const int n = scene_n(settings);
    const double mass = 1.0 / (double(n) * n);
    const MassProfile profile(per_radius, inner, outer - inner);
    const double rings_mass = profile.mass();
    ParticleSet gas;
    gas.dimension = 2;
    gas.box = {{-2, -2, 0}, {4, 4, 1}, {}};
    double left = std::floor(rings_mass / mass + 0.5);  // particles
    for (bool odd = false; left > 0; odd = !odd) {
      const auto place = [&](double outside) {
        return profile.place(std::clamp(1 - outside * mass / rings_mass, 0.0, 1.0));
      };
      const double edge = place(left);
      const double wanted = std::round(2 * std::numbers::pi * edge * n * std::sqrt(density(edge)));
      const double count = std::clamp(wanted, 1.0, left), R = place(left - 0.5 * count);
      for (int k = 0; k < static_cast<int>(count); ++k) {
        const double angle = 2 * std::numbers::pi * (k + (odd ? 0.5 : 0)) / count;
        const double c = std::cos(angle), s = std::sin(angle), v = speed(R, settings);
        gas.x.push_back({R * c, R * s, 0});
        gas.v.push_back({-v * s, v * c, 0});
      }
      left -= count;
    }
    gas.m.assign(gas.size(), mass);
    gas.u.assign(gas.size(), energy(settings));
    return gas;
  }

  /// A ring in balance stays as it is.
  ExactSolution exact(const Settings& settings) const override {
    return [settings](const Array3& x, double) -> GasState {
      const double R = std::hypot(x[0], x[1]), rate = R > 0 ? speed(R, settings) / R : 0;
      return {
          density(R), {-rate * x[1], rate * x[0], 0}, (settings.real("sph.gamma") - 1) * density(R) * energy(settings)};
    };
  }
  /// Within two widths of the middle.
  Errors errors(const Settings& settings, const Snapshot& snapshot) const override {
    ProfileLine line = along_R(middle + 2 * width);
    line.from = middle - 2 * width;
    return profile_errors(snapshot, line, exact(settings));
  }
  /// The ring's mean radius and width over those of the start.
  Measures measures(const Settings&, const Snapshot& snapshot) const override {
    const auto &x = snapshot.field("Coordinates").values, &m = snapshot.field("Masses").values;
    Spread spread;
    for (std::size_t i = 0; i < m.size(); ++i) spread.add(std::hypot(x[3 * i], x[3 * i + 1]), m[i]);
    const Spread start = spread_at_start();
    return {{"ring_radius", spread.mean() / start.mean()}, {"ring_width", spread.deviation() / start.deviation()}};
  }
  PlotHint plot_hint(const Settings&) const override {
    return {.abscissa = "R", .from = inner, .to = outer, .map = true};
  }
  GalleryTile gallery() const override { return {.keys = {"scene.n=32", "time.end=12.566"}}; }

 private:
  /// Specific energy, the same everywhere, for the speed of sound that scene.mach gives at radius 1.
  static double energy(const Settings& settings) {
    const double gamma = settings.real("sph.gamma"), mach = settings.real("scene.mach");
    return settings.real("gravity.central_mass") / (mach * mach * gamma * (gamma - 1));
  }
  /// v^2/R = G M R / (R^2 + softening^2)^(3/2) + (dP/dR)/rho.
  static double speed(double R, const Settings& settings) {
    const double softening = settings.real("gravity.softening"), r2 = R * R + softening * softening;
    const double gravity = settings.real("gravity.central_mass") * R * R / (r2 * std::sqrt(r2));
    const double pressure = -(settings.real("sph.gamma") - 1) * energy(settings) * R * (R - middle) / (width * width);
    return std::sqrt(std::max(gravity + pressure, 0.0));
  }
};

}  // namespace

const Scene& ring_scene = Ring();

}  // namespace sphk
