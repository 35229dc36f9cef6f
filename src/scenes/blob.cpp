// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "src/scenes/block.hpp"
#include "src/scenes/initial_condition.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/mixing.hpp"
#include "src/scenes/scenes.hpp"

namespace sphk {

namespace {

// Units: the cloud's radius, the density and the speed of sound of the wind. The wind blows along x (R10: along z).
constexpr double rho_cloud = 10, wind = 2.7;
constexpr Array3 centre{5, 5, 5}, box_size{30, 10, 10};

/// tau_KH = 1.6 tau_cr, tau_cr = 2 R_cl sqrt(density ratio) / v (R10 sec 7).
double growth_time() {
  return 1.6 * 2 * std::sqrt(rho_cloud) / wind;
}

double pressure(const Settings& settings) {
  return 1 / settings.real("sph.gamma");
}

double energy(const Settings& settings, double rho) {
  return GasState{.rho = rho, .P = pressure(settings)}.u(settings.real("sph.gamma"));
}

Array3 from_centre(const Array3& x) {
  return {x[0] - centre[0], x[1] - centre[1], x[2] - centre[2]};
}

double distance(const Array3& x) {
  const Array3 d = from_centre(x);
  return std::hypot(d[0], d[1], d[2]);
}

/// Radial motion of the cloud's skin, R10 Appendix B: -0.06 v_wind exp(2 (r - 1)) Re Y_5^3 / C with the polar axis
/// along the wind. Re Y_5^3 goes with -cos(3 phi) sin^3(theta) (9 cos^2(theta) - 1), and C makes its maximum 1: the
/// derivative of s^3 (8 - 9 s^2) vanishes at s^2 = 8/15.
Array3 disturbance(const Array3& x) {
  const auto [a, b, c] = from_centre(x);
  const double r = std::hypot(a, b, c);
  if (r == 0) return {};
  const double cosine = a / r, sine = std::hypot(b, c) / r, phi = std::atan2(c, b);
  const double C = std::pow(8.0 / 15, 1.5) * (8 - 9 * 8.0 / 15);
  const double harmonic = -std::cos(3 * phi) * std::pow(sine, 3) * (9 * cosine * cosine - 1) / C;
  const double v_r = -0.06 * wind * std::exp(2 * (r - 1)) * harmonic;
  return {v_r * a / r, v_r * b / r, v_r * c / r};
}

/// The cloud's gas on a lattice of that spacing around the centre.
std::vector<Array3> cloud_points(double spacing) {
  const int across = 2 * static_cast<int>(std::ceil(1 / spacing));
  Block block = centred_cube(3, across, across * spacing / 2);
  for (int axis = 0; axis < 3; ++axis) block.lower[axis] += centre[axis];
  std::vector<Array3> inside;
  for (const Array3& x : lattice_points(block))
    if (distance(x) < 1) inside.push_back(x);
  return inside;
}

class Blob final : public Scene {
 public:
  std::string name() const override { return "blob"; }
  std::string summary() const override { return "a dense cloud in a Mach 2.7 wind (R10 sec 7), tau_KH = 3.748"; }

  void declare(Settings& settings) const override {
    declare_resolution(settings, 48, "wind particles across the box, which is 10 cloud radii wide and 30 long");
    declare_masses(settings, "equal");
    declare_temperatures(settings);
    prefer_unless_set(settings, "output.snapshots", std::int64_t{8});
    prefer_unless_set(settings, "sph.scheme", "sphs");
    prefer_usual_gas(settings, 2 * growth_time());
  }
  bool mixes() const override { return true; }

  ParticleSet build(const Settings& settings) const override {
    const int n = scene_n(settings);
    const double spacing = box_size[1] / n, mass = std::pow(spacing, 3);
    const bool equal = has_equal_masses(settings);
    ParticleSet gas;
    gas.box = {{}, box_size, {true, true, true}};
    const auto wind_lattice = lattice_points({.dimension = 3, .counts = {3 * n, n, n}, .size = box_size});
    for (const Array3& x : wind_lattice)
      if (!equal || distance(x) >= 1) gas.x.push_back(x);
    if (equal)
      for (const Array3& x : cloud_points(spacing / std::cbrt(rho_cloud))) gas.x.push_back(x);
    for (const Array3& x : gas.x) {
      const bool dense = distance(x) < 1;
      gas.v.push_back(dense ? disturbance(x) : Array3{wind, 0, 0});
      gas.m.push_back(dense && !equal ? rho_cloud * mass : mass);
      gas.u.push_back(energy(settings, dense ? rho_cloud : 1));
      gas.tag.push_back(dense ? dense_gas : light_gas);
    }
    smooth_temperatures(gas, pressure(settings), settings);
    return gas;
  }

  Measures measures(const Settings& settings, const Snapshot& snapshot) const override {
    const double u_wind = energy(settings, 1);
    return {{"cloud_mass", cloud_mass(snapshot, {.least_density = 0.64 * rho_cloud, .highest_energy = 0.9 * u_wind})},
            {"cold_share", cold_share(snapshot, 0.5 * u_wind)},
            {"cloud_velocity", cloud_velocity(snapshot)}};
  }
  /// Of grid codes, which spread. Mass alone does not tell mixing: a cloud that is torn, but does not mix, loses it
  /// too.
  std::vector<Reference> references(const Settings&) const override {
    const double tau = growth_time();
    return {{"cloud_mass", 0.5 * tau, 0.736, 0.794, true},
            {"cloud_mass", tau, 0.461, 0.546, true},
            {"cloud_mass", 2 * tau, 0, 0.06, true},
            {"cold_share", tau, 0.80, 0.88}};
  }
  PlotHint plot_hint(const Settings&) const override {
    return {.abscissa = "x", .from = 0, .to = box_size[0], .map = true};
  }
  std::vector<PaperChoice> paper(const Settings&) const override {
    return {{"S12: 126744 particles in the cloud, as near as lattices come", {"scene.n=145"}},
            {"R10, S12: equal masses", {"scene.masses=equal"}},
            {"R10, S12: temperatures of the density that the kernel measures", {"scene.temperatures=smoothed"}},
            {"R10, S12: three growth times", {fmt::format("time.end={}", 3 * growth_time())}},
            {"S12: SPHS, with entropies; R10: OSPH-HOCT4-442, with energies", {"sph.scheme=SPHS-HCT442"}}};
  }
  GalleryTile gallery() const override {
    return {.keys = {"scene.n=32", fmt::format("time.end={:.4g}", growth_time())}};
  }
};

}  // namespace

const Scene& blob_scene = Blob();

}  // namespace sphk
