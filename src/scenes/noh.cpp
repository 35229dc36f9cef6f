// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "src/scenes/block.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/norms.hpp"
#include "src/scenes/scenes.hpp"

namespace sphk {

namespace {

double shock_radius(double t, double gamma) {
  return (gamma - 1) / 2 * t;
}

/// Noh (1987): cold gas of density 1 falls with speed 1 onto the centre; a shock runs outwards at (gamma-1)/2.
GasState noh(const Array3& x, double t, int D, double gamma, double cold_pressure) {
  const double r = radius(x), jump = (gamma + 1) / (gamma - 1);
  if (r < shock_radius(t, gamma)) {
    const double rho = std::pow(jump, D);
    return {rho, {}, (gamma - 1) * rho / 2};  // all the kinetic energy, 1/2 per mass, became heat
  }
  const double rho = r > 0 ? std::pow(1 + t / r, D - 1) : 1, towards = r > 0 ? -1 / r : 0;
  return {rho, {towards * x[0], towards * x[1], towards * x[2]}, cold_pressure * std::pow(rho, gamma)};
}

/// rms over the particles from 0.3 to 0.9 of the shock's radius R of rho / (mean of a bin of r) - 1, with 12 bins; in
/// 1D rms over the bins of the difference between the means of the two sides, over half their sum.
double scatter(const Snapshot& snapshot, double R) {
  constexpr int bins = 12;
  struct Bin {
    double particles = 0, sum = 0, squares = 0;
    double mean() const { return sum / particles; }
  };
  std::array<std::array<Bin, bins>, 2> sides{};  // x < 0, x > 0 in 1D; else all gas in the first
  const auto x = rows(snapshot.field("Coordinates"));
  const auto& rho = snapshot.field("Densities").values;
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    const double place = (radius(x[i]) / R - 0.3) / 0.6 * bins;
    if (!(place >= 0 && place < bins)) continue;
    Bin& bin = sides[snapshot.dimension == 1 && x[i][0] > 0][static_cast<std::size_t>(place)];
    ++bin.particles;
    bin.sum += rho[i];
    bin.squares += rho[i] * rho[i];
  }
  double sum = 0, count = 0;
  for (int b = 0; b < bins; ++b) {
    const Bin &left = sides[0][b], &right = sides[1][b];
    if (left.particles > 0 && snapshot.dimension > 1) {
      sum += std::max(left.squares / (left.mean() * left.mean()) - left.particles, 0.0);
      count += left.particles;
    } else if (left.particles > 0 && right.particles > 0) {
      sum += std::pow(2 * (left.mean() - right.mean()) / (left.mean() + right.mean()), 2);
      ++count;
    }
  }
  return count > 0 ? std::sqrt(sum / count) : 0;
}

/// Mean u within a tenth of the shock's radius R, or of the innermost particles where none lies there, over the exact
/// 1/2, less 1.
double wall_heating(const Snapshot& snapshot, double R) {
  const auto x = rows(snapshot.field("Coordinates"));
  const auto& u = snapshot.field("InternalEnergies").values;
  const auto distance = [&](std::size_t i) { return radius(x[i]); };
  double innermost = std::numeric_limits<double>::infinity(), sum = 0, count = 0;
  for (std::size_t i = 0; i < u.size(); ++i) innermost = std::min(innermost, distance(i));
  for (std::size_t i = 0; i < u.size(); ++i)
    if (distance(i) <= std::max(0.1 * R, innermost * (1 + 1e-6))) sum += u[i], ++count;
  return sum / count / 0.5 - 1;
}

/// Mean errors of density and radial velocity on 0.05 <= r <= 0.35, each particle of the line x > 0 with the length
/// that is nearest to it: the norm of the planar test of Spheral (Noh-planar-1d.py), which leaves the heated gas at the
/// wall out.
Measures errors_on_the_line(const Snapshot& snapshot, double R, double gamma) {
  const auto &x = snapshot.field("Coordinates").values, &v = snapshot.field("Velocities").values;
  const auto& rho = snapshot.field("Densities").values;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < rho.size(); ++i)
    if (x[3 * i] > 0) order.push_back(i);
  std::ranges::sort(order, {}, [&](std::size_t i) { return x[3 * i]; });
  double length = 0, off_rho = 0, off_v = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto at = [&](std::size_t other) { return x[3 * order[other]]; };
    const double from = k > 0 ? (at(k - 1) + at(k)) / 2 : 0,
                 to = k + 1 < order.size() ? (at(k) + at(k + 1)) / 2 : at(k);
    const double share = std::max(std::min(to, 0.35) - std::max(from, 0.05), 0.0);
    const GasState exact = noh({at(k), 0, 0}, R / ((gamma - 1) / 2), 1, gamma, 0);
    length += share;
    off_rho += share * std::abs(rho[order[k]] - exact.rho);
    off_v += share * std::abs(v[3 * order[k]] - exact.v[0]);
  }
  return {{"line_error_rho", off_rho / length}, {"line_error_v", off_v / length}};
}

class Noh : public Scene {
 public:
  std::string name() const override { return "noh"; }
  std::string summary() const override { return "cold gas falls onto its centre: infinite Mach number, wall heating"; }

  void declare(Settings& settings) const override {
    declare_resolution(settings, 50, "particles per unit length; the gas fills the unit ball, 2n across");
    declare_dimension(settings, 3);
    declare_arrangement(settings, "cubic");
    declare_real(settings, "scene.cold_pressure", 1e-6, "pressure of the cold gas at the start", {.min = 1e-300});
    prefer_usual_gas(settings, 0.6);
  }

  ParticleSet build(const Settings& settings) const override {
    const int D = scene_dimension(settings), n = scene_n(settings);
    const Block block = centred_cube(D, 2 * n, 1);
    ParticleSet gas;
    gas.dimension = D;
    gas.box = {block.lower, block.size, {}};
    for (const Array3& x : arranged_points(block, settings.text("scene.lattice")))
      if (radius(x) < 1) gas.x.push_back(x);
    const double P = settings.real("scene.cold_pressure"), gamma = settings.real("sph.gamma");
    for (const Array3& x : gas.x) gas.v.push_back(noh(x, 0, D, gamma, P).v);
    gas.m.assign(gas.size(), std::pow(1.0 / n, D));
    gas.u.assign(gas.size(), GasState{.rho = 1, .P = P}.u(gamma));
    return gas;
  }

  ExactSolution exact(const Settings& settings) const override {
    const int D = scene_dimension(settings);
    const double gamma = settings.real("sph.gamma"), P = settings.real("scene.cold_pressure");
    return [=](const Array3& x, double t) { return noh(x, t, D, gamma, P); };
  }
  /// Inside 3/4 of the radius that the edge has fallen to: the outermost particles miss neighbours on one side.
  Errors errors(const Settings& settings, const Snapshot& snapshot) const override {
    return profile_errors(snapshot, along_r(0.75 * (1 - snapshot.time)), exact(settings));
  }
  /// How uneven the gas behind the shock is, and how much too hot at the centre; at the start -1, as nothing is hot
  /// yet. In 1D also the errors as Spheral takes them.
  Measures measures(const Settings& settings, const Snapshot& snapshot) const override {
    const double R = shock_radius(snapshot.time, settings.real("sph.gamma"));
    Measures found{{"scatter", R > 0 ? scatter(snapshot, R) : 0}, {"wall_heating", wall_heating(snapshot, R)}};
    if (scene_dimension(settings) == 1)
      for (auto& error : errors_on_the_line(snapshot, R, settings.real("sph.gamma"))) found.push_back(std::move(error));
    return found;
  }
  PlotHint plot_hint(const Settings&) const override { return {.abscissa = "r", .from = 0, .to = 0.4}; }
  GalleryTile gallery() const override { return {.keys = {"scene.n=100", "scene.dimension=2"}}; }
};

}  // namespace

const Scene& noh_scene = Noh();

}  // namespace sphk
