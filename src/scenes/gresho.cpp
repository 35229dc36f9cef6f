// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/scenes/block.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/norms.hpp"
#include "src/scenes/scenes.hpp"

namespace sphk {

namespace {

/// Azimuthal velocity, S12 eq 45.
double speed(double R) {
  return R < 0.2 ? 5 * R : R < 0.4 ? 2 - 5 * R : 0;
}

/// Pressure that balances it, S12 eq 46.
double pressure(double R) {
  if (R < 0.2) return 5 + 12.5 * R * R;
  if (R < 0.4) return 9 + 12.5 * R * R - 20 * R + 4 * std::log(R / 0.2);
  return 3 + 4 * std::log(2.0);
}

GasState vortex(const Array3& x) {
  const double R = std::hypot(x[0], x[1]), rate = R > 0 ? speed(R) / R : 5;
  return {1, {-rate * x[1], rate * x[0], 0}, pressure(R)};
}

/// Where a place of time t was at the start in the box around the origin, when all gas moves with `boost` along x and
/// y.
Array3 unmoved(const Array3& x, double boost, double t) {
  if (boost == 0) return x;
  return {wrapped(x[0] - boost * t + 0.5, 1) - 0.5, wrapped(x[1] - boost * t + 0.5, 1) - 0.5, x[2]};
}

Block block_of(const Settings& settings) {
  const int n = scene_n(settings), layers = static_cast<int>(settings.integer("scene.layers"));
  Block block{.dimension = scene_dimension(settings), .counts = {n, n, 1}, .lower = {-0.5, -0.5, 0}};
  if (block.dimension == 2) return block;
  block.counts[2] = layers > 0 ? layers : std::max(n / 8, 1);
  block.size[2] = double(block.counts[2]) / n;
  return block;
}

class Gresho : public Scene {
 public:
  std::string name() const override { return "gresho"; }
  std::string summary() const override { return "vortex in balance: viscosity and noise in shear (S12 sec 7.3)"; }

  void declare(Settings& settings) const override {
    declare_resolution(settings, 64, "particles along the unit box");
    declare_dimension(settings, 3, 2);
    declare_integer(settings, "scene.layers", 0, "particles along the axis of the vortex; 0: n/8, as in S12",
                    {.min = 0, .max = 100000});
    declare_arrangement(settings, "cubic");
    declare_real(settings, "scene.boost", 0.0, "speed of all gas along x and y");
    prefer_usual_gas(settings, 1.0);
  }

  ParticleSet build(const Settings& settings) const override {
    const auto start = exact(settings);
    ParticleSet gas = even_gas(block_of(settings), settings.text("scene.lattice"));
    gas.v.clear();
    for (const Array3& x : gas.x) {
      const GasState state = start(x, 0);
      gas.v.push_back(state.v);
      gas.u.push_back(state.u(settings.real("sph.gamma")));
    }
    return gas;
  }

  /// The vortex moves with the boost through the periodic box.
  ExactSolution exact(const Settings& settings) const override {
    return [boost = settings.real("scene.boost")](const Array3& x, double t) {
      GasState state = vortex(unmoved(x, boost, t));
      for (int axis = 0; axis < 2; ++axis) state.v[axis] += boost;
      return state;
    };
  }
  /// In the frame of the vortex.
  Errors errors(const Settings& settings, const Snapshot& snapshot) const override {
    Snapshot resting = snapshot;
    const double boost = settings.real("scene.boost");
    resting.let_go();
    const auto values = [&](const char* name) -> std::vector<double>& {
      Field& field = *std::ranges::find(resting.fields, name, &Field::name);
      field.fill();
      return field.values;
    };
    std::vector<double>&x = values("Coordinates"), &v = values("Velocities");
    for (std::size_t i = 0; i < resting.size(); ++i) {
      std::ranges::copy(unmoved({x[3 * i], x[3 * i + 1], x[3 * i + 2]}, boost, snapshot.time), &x[3 * i]);
      for (int axis = 0; axis < 2; ++axis) v[3 * i + axis] -= boost;
    }
    return profile_errors(resting, along_R(0.5), [](const Array3& place, double) { return vortex(place); });
  }
  std::vector<PaperChoice> paper(const Settings&) const override {
    return {{"S12: SPHS, and SPH, by the labels of its Fig. 6", {"sph.scheme=SPHS-HCT442"}}};
  }
  /// Around the centre of the vortex at the end.
  PlotHint plot_hint(const Settings& settings) const override {
    const double boost = settings.real("scene.boost");
    return {.abscissa = "R", .from = 0, .to = 0.5, .velocity = {boost, boost, 0}};
  }
  GalleryTile gallery() const override {
    return {.keys = {"scene.n=32", "scene.lattice=glass", "sph.scheme=sphs-morris", "sph.kernel=hoct4",
                     "sph.neighbours=442", "time.courant=0.4"},
            .field = "v"};
  }
};

}  // namespace

const Scene& gresho_scene = Gresho();

}  // namespace sphk
