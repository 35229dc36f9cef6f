// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "src/scenes/block.hpp"
#include "src/scenes/mixing.hpp"
#include "src/scenes/scene.hpp"

namespace sphk {

/// Two gases in pressure balance that stream past each other along x: dense between the interfaces in y, light beyond.
struct LayeredFlow {
  double lower = 0;  ///< of the unit box along x and y
  double pressure = 1;
  double rho_light = 1, rho_dense = 2;  ///< far from the interfaces
  std::array<double, 2> interfaces{};
  double wavelength = 0.5;  ///< of the disturbance v_y
  std::function<double(double y)> rho, v_x;
  std::function<double(double x, double y)> v_y;
};

/// What the Kelvin-Helmholtz scenes share: keys, particles and measures of a periodic unit square (2D) or of a thin
/// periodic slab of it (3D).
class ShearLayers : public Scene {
 public:
  void declare(Settings& settings) const override;
  bool mixes() const override { return true; }
  /// Tagged by the layer at the start (mixing.hpp).
  ParticleSet build(const Settings& settings) const override;
  void set_velocities(ParticleSet& gas, const Settings& settings) const override;
  Measures measures(const Settings&, const Snapshot&) const override;
  PlotHint plot_hint(const Settings&) const override;

 protected:
  struct Defaults {
    int n = 64, dimension = 3;
    double end = 1;
    int snapshots = 10;
  };
  virtual Defaults defaults() const = 0;
  virtual LayeredFlow flow(const Settings& settings) const = 0;
  /// Positions and masses for scene.masses = "equal": by default the blocks below, along the density.
  virtual void place_equal_masses(ParticleSet& gas, const LayeredFlow& flow, const Settings& settings) const;
  /// The blocks of scene.masses = "equal", with the fraction of the mass below in place of y; `even` fills the box.
  virtual std::vector<Block> equal_mass_blocks(const Block& even) const;
};

}  // namespace sphk
