// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/scaled_simulation.hpp"

#include "kernels/core/error_fields.hpp"
#include "src/engine/archive.hpp"
#include "src/engine/host_columns.hpp"
#include "src/engine/step_errors.hpp"

namespace sphk {

namespace {

constexpr const char* block = "own units";

Array3 scaled(Array3 values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

/// f(), with what it says of a particle in the user's units.
template <class F>
auto told_in(const Scale& scale, F&& f) {
  try {
    return f();
  } catch (const StuckError& error) {
    StuckParticle particle = error.particle;
    particle.x = scaled(particle.x, scale.factor(length_unit));
    for (double* time : {&particle.time, &particle.dt, &particle.shortest}) *time *= scale.factor(time_unit);
    throw StuckError(error.reason, particle);
  }
}

}  // namespace

ScaledSimulation::ScaledSimulation(const std::function<std::unique_ptr<Simulation>()>& make, const Scale& scale,
                                   int dimension, double gamma)
    : inner_(told_in(scale, make)), scale_(scale), dimension_(dimension), gamma_(gamma) {}

StepReport ScaledSimulation::step(double t_end) {
  return told_in(scale_, [&] { return outer(inner_->step(t_end / scale_.factor(time_unit))); });
}

void ScaledSimulation::heat(const Array3& place, double energy) {
  told_in(scale_,
          [&] { inner_->heat(scaled(place, 1 / scale_.factor(length_unit)), energy / scale_.factor(energy_unit)); });
}

void ScaledSimulation::add(const Gains& gains) {
  Gains inner = gains;
  for (double& v : inner.velocity) v /= scale_.factor(speed_unit);
  for (double& u : inner.energy) u /= scale_.factor(specific_energy_unit);
  told_in(scale_, [&] { inner_->add(inner); });
}

double ScaledSimulation::time() const {
  return inner_->time() * scale_.factor(time_unit);
}

Totals ScaledSimulation::totals() const {
  Totals totals = inner_->totals();
  const double energy = scale_.factor(energy_unit), density = scale_.factor(density_unit(dimension_));
  totals.mass *= scale_.factor(mass_unit);
  for (double* each : {&totals.kinetic, &totals.thermal, &totals.potential, &totals.heated}) *each *= energy;
  const double momentum = scale_.factor({.length = 1, .mass = 1, .time = -1});
  const double angular_momentum = momentum * scale_.factor(length_unit);
  totals.momentum = scaled(totals.momentum, momentum);
  totals.momentum_sizes *= momentum;
  totals.angular_momentum = scaled(totals.angular_momentum, angular_momentum);
  totals.angular_momentum_sizes *= angular_momentum;
  totals.max_speed *= scale_.factor(speed_unit);
  for (double* each : {&totals.min_density, &totals.max_density}) *each *= density;
  for (double* each : {&totals.min_pressure, &totals.max_pressure})
    *each *= density * scale_.factor(specific_energy_unit);
  const double entropy = scale_.factor(exponents(Entropy::facts.unit, dimension_, gamma_));
  for (double* each : {&totals.min_entropy, &totals.max_entropy}) *each *= entropy;
  return totals;
}

Snapshot ScaledSimulation::view() const {
  Snapshot view = inner_->view();
  view.time *= scale_.factor(time_unit);
  for (Field& field : view.fields)
    field.make = [make = std::move(field.make), factor = scale_.factor(field.units)] {
      std::vector<double> values = make();
      for (double& value : values) value *= factor;
      return values;
    };
  return view;
}

HeldParticles ScaledSimulation::held() const {
  HeldParticles held = inner_->held();
  for (HeldField& field : held.fields) field.factor = scale_.factor(field.units);
  return held;
}

void ScaledSimulation::save(const TakeBlock& take) const {
  inner_->save(take);
  StateWriter{take}(block, scale_);
}

void ScaledSimulation::restore(const GiveBlock& give) {
  if (scale_of(give) != scale_) throw InputError("the checkpoint is of a run that computes in other units");
  inner_->restore(give);
}

StepReport ScaledSimulation::outer(StepReport report) const {
  report.time *= scale_.factor(time_unit);
  report.dt *= scale_.factor(time_unit);
  report.limiting_x = scaled(report.limiting_x, scale_.factor(length_unit));
  return report;
}

std::vector<Field> ScaledSimulation::outer(std::vector<Field> fields) const {
  for (Field& field : fields) {
    const double factor = scale_.factor(field.units);
    for (double& value : field.values) value *= factor;
  }
  return fields;
}

SimulationSettings in_own_units(SimulationSettings settings, const Scale& scale,
                                const std::vector<const Number*>& numbers, int dimension) {
  settings.own_units = scale;
  settings.h_max /= scale.factor(length_unit);
  settings.max_dt /= scale.factor(time_unit);
  for (const Number* number : numbers) {
    const double factor = scale.factor(exponents(number->unit, dimension, settings.gamma));
    if (factor != 1) settings.numbers.set(number->key, settings.numbers[*number] / factor);
  }
  return settings;
}

Scale scale_of(const GiveBlock& give) {
  Scale scale;
  StateReader{give}(block, scale);
  return scale;
}

}  // namespace sphk
