// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/scenes/scene.hpp"

namespace sphk {

/// A point explosion of energy scene.energy in even, cold gas of density 1 that fills the unit box around the origin,
/// evenly sampled or more coarsely at one side: what its scenes share. They differ in the gas at rest and in who gets
/// the energy.
class Explosion : public Scene {
 public:
  void declare(Settings& settings) const override;
  ParticleSet build(const Settings& settings) const override;
  /// Sedov's self-similar solution.
  ExactSolution exact(const Settings& settings) const override;
  Errors errors(const Settings& settings, const Snapshot& snapshot) const override;
  /// peak_density: (gamma+1)/(gamma-1) when resolved, 4 for gamma 5/3. blast_radius: where the shock of a blast with
  /// the same mean radius of the kinetic energy stands; blast_radius_exact: where it should.
  /// roundness: spread of the mean radius between the directions along the axes, relative; 0 is round.
  Measures measures(const Settings&, const Snapshot& snapshot) const override;
  PlotHint plot_hint(const Settings&) const override { return {.abscissa = "r", .from = 0, .to = 0.5}; }

 protected:
  /// Pressure of the gas at rest.
  virtual double ambient_pressure(const Settings& settings) const = 0;
  /// When the gas explodes.
  virtual double start(const Settings&) const { return 0; }
  /// Adds scene.energy to the gas at rest, if it explodes at t = 0.
  virtual void explode(ParticleSet& gas, const Settings& settings) const = 0;
};

}  // namespace sphk
