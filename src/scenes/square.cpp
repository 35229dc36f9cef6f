// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/engine/errors.hpp"
#include "src/scenes/block.hpp"
#include "src/scenes/initial_condition.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/nearest.hpp"
#include "src/scenes/norms.hpp"
#include "src/scenes/scenes.hpp"

namespace sphk {

namespace {

constexpr double pressure = 2.5;
constexpr int thin_gas = 0, dense_gas = 1;  // tags

/// Dense gas in the middle half of a periodic box, in pressure balance with the thin gas around it (Saitoh & Makino
/// 2013, sec 5.3): it keeps its shape, at rest, in motion, in shear, and where the masses of the particles jump.
class Square final : public Scene {
 public:
  std::string name() const override { return "square"; }
  std::string summary() const override {
    return "a dense square in pressure balance: no motion, no blips of the pressure";
  }

  void declare(Settings& settings) const override {
    declare_resolution(settings, 32, "particles of the thin gas along the unit box; a multiple of 4");
    declare_dimension(settings, 2, 2);
    declare_real(settings, "scene.ratio", 4.0, "density of the dense gas over that of the thin",
                 {.min = 1, .max = 1e9});
    declare_masses(settings, "multi");
    declare_integer(settings, "scene.finer", 1,
                    "spacing of the thin gas over that of the dense, with scene.masses = multi",
                    {.min = 1, .max = 100});
    declare_choice(settings, "scene.shape", "square",
                   "of the dense gas: square (in 3D a cube) | layer: 0.25 < y < 0.75", {"square", "layer"});
    declare_real(settings, "scene.shear", 0.0,
                 "speed of a dense layer along x relative to the thin gas, half each way");
    declare_temperatures(settings);
    declare_real(settings, "scene.boost", 0.0, "speed of all gas along x and y");
    prefer_unless_set(settings, "sph.scheme", "sphs");
    prefer_usual_gas(settings, 1);
  }
  bool mixes() const override { return true; }

  /// Equal masses: the dense gas on a lattice that is finer by the nearest whole number of particles a side.
  ParticleSet build(const Settings& settings) const override {
    const Problem problem(settings);
    const int D = problem.dimension, n = scene_n(settings);
    Block thin{.dimension = D, .counts = even_counts(D, n)}, dense = thin;
    for (int axis = 0; axis < D; ++axis) {
      const bool bounded = problem.bounded(axis);
      if (bounded) dense.lower[axis] = 0.25, dense.size[axis] = 0.5;
      dense.counts[axis] = finer_side(settings) * (bounded ? 1 : 2);
    }
    ParticleSet gas;
    gas.dimension = D;
    gas.box = {thin.lower, thin.size, {true, true, D > 2}};
    const auto add = [&](const Array3& x, int tag, double volume) {
      const double rho = problem.density(tag);
      gas.x.push_back(x);
      gas.v.push_back(problem.velocity(tag));
      gas.m.push_back(rho * volume);
      gas.u.push_back(GasState{.rho = rho, .P = pressure}.u(settings.real("sph.gamma")));
      gas.tag.push_back(tag);
    };
    for (const Array3& x : lattice_points(thin))
      if (problem.tag_at(x, 0) == thin_gas) add(x, thin_gas, std::pow(1.0 / n, D));
    for (const Array3& x : lattice_points(dense)) add(x, dense_gas, std::pow(0.5 / finer_side(settings), D));
    smooth_temperatures(gas, pressure, settings);
    return gas;
  }

  ExactSolution exact(const Settings& settings) const override {
    return [problem = Problem(settings)](const Array3& x, double t) -> GasState {
      const int tag = problem.tag_at(x, t);
      return {problem.density(tag), problem.velocity(tag), pressure};
    };
  }

  /// pressure_error: largest distance of a particle's pressure from the exact one, over it. mach: largest speed beside
  /// the velocity that the particle started with, over the speed of sound of the dense gas. gap: below. drift: of the
  /// dense gas' centre of mass from where the boost carries it, over the box; of a layer across it.
  Measures measures(const Settings& settings, const Snapshot& snapshot) const override {
    const Problem problem(settings);
    const auto x = rows(snapshot.field("Coordinates")), v = rows(snapshot.field("Velocities"));
    const auto &P = snapshot.field("Pressures").values, &tag = snapshot.field("PhaseTags").values;
    const auto& m = snapshot.field("Masses").values;
    double blip = 0, speed = 0, mass = 0;
    Array3 moment{};
    for (std::size_t i = 0; i < snapshot.size(); ++i) {
      const Array3 start = problem.velocity(static_cast<int>(tag[i]));
      blip = std::max(blip, std::abs(P[i] / pressure - 1));
      speed = std::max(speed, std::hypot(v[i][0] - start[0], v[i][1] - start[1], v[i][2] - start[2]));
      if (tag[i] != dense_gas) continue;
      mass += m[i];
      const Array3 place = problem.unmoved(x[i], snapshot.time);
      for (int axis = 0; axis < problem.dimension; ++axis)
        if (problem.bounded(axis)) moment[axis] += m[i] * (place[axis] - 0.5);
    }
    const double c = std::sqrt(settings.real("sph.gamma") * pressure / problem.density(dense_gas));
    return {{"pressure_error", blip},
            {"mach", speed / c},
            {"gap", gap(problem, snapshot)},
            {"drift", radius(moment) / mass}};
  }
  /// Through the middle of the dense gas at the end.
  PlotHint plot_hint(const Settings& settings) const override {
    const Problem problem(settings);
    return {.abscissa = problem.layer ? "y" : "x",
            .from = 0,
            .to = 1,
            .centre = problem.unmoved({0.5, 0.5, 0.5}, -settings.real("time.end")),
            .map = true};
  }
  GalleryTile gallery() const override { return {.keys = {"scene.n=32"}}; }

 private:
  struct Problem {
    int dimension;
    bool layer;
    double ratio, boost, shear;

    /// Throws InputError where the keys contradict each other.
    explicit Problem(const Settings& settings)
        : dimension(scene_dimension(settings)),
          layer(settings.text("scene.shape") == "layer"),
          ratio(settings.real("scene.ratio")),
          boost(settings.real("scene.boost")),
          shear(settings.real("scene.shear")) {
      if (shear != 0 && !layer)
        throw InputError("scene.shear needs a layer to slide along the thin gas; set scene.shape = \"layer\" as well");
      if (scene_n(settings) % 4 != 0)
        throw InputError(
            fmt::format("scene.n = {}: the edges of the dense gas need a multiple of 4", scene_n(settings)));
      if (has_equal_masses(settings) && settings.integer("scene.finer") != 1)
        throw InputError("scene.finer sets how the masses jump; leave it, or scene.masses = \"equal\", away");
    }
    /// The dense gas ends along this axis, at 0.25 and 0.75.
    bool bounded(int axis) const { return axis < dimension && (axis == 1 || !layer); }
    /// Where the boost took the place x at time t from, in the unit box.
    Array3 unmoved(Array3 x, double t) const {
      for (int axis = 0; axis < dimension; ++axis) x[axis] = wrapped(x[axis] - (axis < 2 ? boost * t : 0), 1);
      return x;
    }
    /// x lies in the dense gas at the start, wherever it is along the axis `beside`.
    bool inside(const Array3& x, int beside = -1) const {
      for (int axis = 0; axis < dimension; ++axis)
        if (axis != beside && bounded(axis) && !(x[axis] > 0.25 && x[axis] < 0.75)) return false;
      return true;
    }
    int tag_at(const Array3& x, double t) const { return inside(unmoved(x, t)) ? dense_gas : thin_gas; }
    double density(int tag) const { return tag == dense_gas ? ratio : 1; }
    Array3 velocity(int tag) const { return {boost + (tag == dense_gas ? shear : -shear) / 2, boost, 0}; }
  };

  /// Particles of the dense gas along half the unit box.
  static int finer_side(const Settings& settings) {
    const double finer = has_equal_masses(settings)
                             ? std::pow(settings.real("scene.ratio"), 1.0 / scene_dimension(settings))
                             : static_cast<double>(settings.integer("scene.finer"));
    return static_cast<int>(std::lround(scene_n(settings) / 2 * finer));
  }

  /// Diameter of the largest empty sphere with its centre at an edge of the dense gas, over the largest h (support
  /// radius) in the thin gas: from 1 on, particles no longer see each other across the gap. Its centre is sought on
  /// grids of h/8 in the faces and up to h/4 beside them, and from the best place there in ever shorter steps.
  static double gap(const Problem& problem, const Snapshot& snapshot) {
    const auto &tag = snapshot.field("PhaseTags").values, &h = snapshot.field("SmoothingLength").values;
    double h_max = 0;
    for (std::size_t i = 0; i < snapshot.size(); ++i)
      if (tag[i] == thin_gas) h_max = std::max(h_max, h[i]);
    const NearestParticle nearest(snapshot);
    double widest = 0;
    Array3 centre{};
    const auto try_place = [&](const Array3& x) {
      if (const double empty = nearest.distance(x); empty > widest) widest = empty, centre = x;
    };
    for (int axis = 0; axis < problem.dimension; ++axis) {
      if (!problem.bounded(axis)) continue;
      Block grid{.dimension = problem.dimension,
                 .counts = even_counts(problem.dimension, static_cast<int>(std::ceil(8 / h_max)))};
      grid.counts[axis] = 1;
      for (Array3 x : lattice_points(grid)) {
        if (!problem.inside(x, axis)) continue;
        for (const double face : {0.25, 0.75})
          for (int beside = -2; beside <= 2; ++beside) {
            x[axis] = face + beside * h_max / 8;
            try_place(problem.unmoved(x, -snapshot.time));
          }
      }
    }
    for (double step = h_max / 16; step > h_max / 1000; step /= 2)
      for (int axis = 0; axis < problem.dimension; ++axis)
        for (const int side : {-1, 1}) {
          Array3 x = centre;
          x[axis] += side * step;
          try_place(x);
        }
    return 2 * widest / h_max;
  }
};

}  // namespace

const Scene& square_scene = Square();

}  // namespace sphk
