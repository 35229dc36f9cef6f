// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numeric>

#include "src/scenes/block.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/nearest.hpp"
#include "src/scenes/norms.hpp"
#include "src/scenes/random.hpp"
#include "src/scenes/scenes.hpp"

namespace sphk {

namespace {

Block block_of(const Settings& settings) {
  const int D = scene_dimension(settings), n = scene_n(settings);
  const int layers = static_cast<int>(settings.integer("scene.layers"));
  Block block{.dimension = D, .counts = even_counts(D, n)};
  if (layers > 0 && D > 1) {
    block.counts[D - 1] = layers;
    block.size[D - 1] = double(layers) / n;
  }
  return block;
}

class UniformGas : public Scene {
 public:
  std::string name() const override { return "uniform"; }
  std::string summary() const override { return "even gas at rest in a periodic box: density errors, speed"; }

  void declare(Settings& settings) const override {
    declare_resolution(settings, 32, "particles along the unit box");
    declare_dimension(settings, 3);
    declare_integer(settings, "scene.layers", 0, "particles along the last axis, for thin slabs; 0: n",
                    {.min = 0, .max = 100000});
    declare_arrangement(settings, "glass");
    declare_real(settings, "scene.jitter", 0.0,
                 "random shift of every particle, up to this many spacings along each axis", {.min = 0, .max = 10});
    declare_integer(settings, "scene.seed", 1, "of the random places and shifts", {.min = 0});
    prefer_usual_gas(settings, 0.1);
  }

  /// rho = 1, P = 1.
  ParticleSet build(const Settings& settings) const override {
    ParticleSet gas = even_gas(block_of(settings), settings.text("scene.lattice"), settings.integer("scene.seed"));
    gas.u.assign(gas.size(), GasState{.rho = 1, .P = 1}.u(settings.real("sph.gamma")));
    shake(gas, settings.real("scene.jitter") / scene_n(settings), Uniform(settings.integer("scene.seed")));
    return gas;
  }

  ExactSolution exact(const Settings&) const override {
    return [](const Array3&, double) { return GasState{1, {}, 1}; };
  }
  Errors errors(const Settings& settings, const Snapshot& snapshot) const override {
    return profile_errors(snapshot, along_x(0, 1), exact(settings));
  }
  /// density_scatter: standard deviation of the particles' densities over their mean. nearest: distance to the nearest
  /// neighbour that 5 % of the particles fall short of, over the mean spacing.
  Measures measures(const Settings&, const Snapshot& snapshot) const override {
    const std::vector<double>& rho = snapshot.field("Densities").values;
    const auto x = rows(snapshot.field("Coordinates"));
    const auto count = static_cast<double>(snapshot.size());
    const double mean = std::accumulate(rho.begin(), rho.end(), 0.0) / count;
    double variance = 0;
    for (const double one : rho) variance += (one - mean) * (one - mean) / count;
    const NearestParticle nearest(snapshot);
    std::vector<double> distances(snapshot.size());
    for (std::size_t i = 0; i < distances.size(); ++i) distances[i] = nearest.distance(x[i], i);
    const auto fifth = distances.begin() + static_cast<std::ptrdiff_t>(snapshot.size() / 20);
    std::ranges::nth_element(distances, fifth);
    const Array3& size = snapshot.box.size;
    const double spacing = std::pow(size[0] * size[1] * size[2] / count, 1.0 / snapshot.dimension);
    return {{"density_scatter", std::sqrt(variance) / mean}, {"nearest", *fifth / spacing}};
  }
  GalleryTile gallery() const override { return {.keys = {"scene.n=24"}}; }

 private:
  static void shake(ParticleSet& gas, double largest, Uniform uniform) {
    if (largest == 0) return;
    for (Array3& x : gas.x)
      for (int axis = 0; axis < gas.dimension; ++axis)
        x[axis] = wrapped(x[axis] + largest * (2 * uniform() - 1), gas.box.size[axis]);
  }
};

}  // namespace

const Scene& uniform_scene = UniformGas();

}  // namespace sphk
