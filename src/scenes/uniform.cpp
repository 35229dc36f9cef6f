#include <algorithm>

#include "src/scenes/block.hpp"
#include "src/scenes/keys.hpp"
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
    settings.declare({.name = "scene.layers", .value = std::int64_t{0},
                      .doc = "particles along the last axis, for thin slabs; 0: n", .choices = {}, .min = 0,
                      .max = 100000});
    declare_arrangement(settings, "glass");
    settings.declare({.name = "scene.jitter", .value = 0.0,
                      .doc = "random shift of every particle, up to this many spacings along each axis", .choices = {},
                      .min = 0, .max = 10});
    settings.declare({.name = "scene.seed", .value = std::int64_t{1}, .doc = "of the random shifts", .choices = {},
                      .min = 0});
    prefer_usual_gas(settings, 0.1);
    adapt(settings);
  }
  void adapt(Settings& settings) const override {
    prefer_usual_kernel(settings, scene_dimension(settings));
  }

  /// rho = 1, P = 1.
  ParticleSet build(const Settings& settings) const override {
    const Block block = block_of(settings);
    ParticleSet gas;
    gas.dimension = block.dimension;
    gas.box = {block.lower, block.size, {true, block.dimension > 1, block.dimension > 2}};
    gas.x = arranged_points(block, settings.text("scene.lattice"));
    gas.v.assign(gas.size(), {});
    gas.m.assign(gas.size(), block.size[0] * block.size[1] * block.size[2] / double(gas.size()));
    gas.u.assign(gas.size(), 1 / (settings.real("sph.gamma") - 1));
    shake(gas, settings.real("scene.jitter") / scene_n(settings), Uniform(settings.integer("scene.seed")));
    return gas;
  }

  std::function<GasState(const Array3&, double)> exact(const Settings&) const override {
    return [](const Array3&, double) { return GasState{1, {}, 1}; };
  }
  std::map<std::string, ErrorNorm> errors(const Settings& settings, const Snapshot& snapshot) const override {
    return profile_errors(snapshot, along_x(0, 1), exact(settings));
  }

 private:
  static void shake(ParticleSet& gas, double largest, Uniform uniform) {
    if (largest == 0) return;
    for (Array3& x : gas.x)
      for (int axis = 0; axis < gas.dimension; ++axis)
        x[axis] = wrapped(x[axis] + largest * (2 * uniform() - 1), gas.box.size[axis]);
  }
};

}  // namespace

const Scene& uniform_scene() {
  static const UniformGas scene;
  return scene;
}

}  // namespace sphk
