// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "src/engine/simulation.hpp"

namespace sphk {

/// A run that computes in units of its own, for a user with others: everything that goes in or out is in the user's.
class ScaledSimulation final : public Simulation {
 public:
  /// `make` makes the run in its own units.
  ScaledSimulation(const std::function<std::unique_ptr<Simulation>()>& make, const Scale& scale, int dimension,
                   double gamma);

  StepReport step(double t_end) override;
  void heat(const Array3& place, double energy) override;
  void add(const Gains& gains) override;
  double time() const override;
  std::size_t size() const override { return inner_->size(); }
  Totals totals() const override;
  Costs costs() const override { return inner_->costs(); }
  StepReport last_step() const override { return outer(inner_->last_step()); }
  Snapshot view() const override;
  HeldParticles held() const override;
  std::vector<Field> rates(bool split) override { return outer(inner_->rates(split)); }
  std::vector<Field> errors() const override { return outer(inner_->errors()); }
  void save(const TakeBlock& take) const override;
  void restore(const GiveBlock& give) override;
  Counts counts() const override { return inner_->counts(); }

 private:
  StepReport outer(StepReport report) const;
  std::vector<Field> outer(std::vector<Field> fields) const;

  std::unique_ptr<Simulation> inner_;
  Scale scale_;
  int dimension_;
  double gamma_;
};

/// The settings of a run in units of its own. `numbers`: all that its terms and passes know.
SimulationSettings in_own_units(SimulationSettings settings, const Scale& scale,
                                const std::vector<const Number*>& numbers, int dimension);

/// The units of the run whose state this is. Throws InputError where there are none.
Scale scale_of(const GiveBlock& give);

}  // namespace sphk
