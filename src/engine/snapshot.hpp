#pragma once

#include "src/engine/host_columns.hpp"
#include "src/engine/scheme_interface.hpp"

namespace sphk {

/// The state on the host, sorted by id, positions wrapped into the box.
template <class L>
Snapshot take_snapshot(const Particles<L>& particles, const CompiledFacts& facts, const Box& box, double time,
                       long step) {
  constexpr int D = L::dimension;
  const HostColumns<L> host(particles);
  const double gamma = particles.parameters.gamma;
  const auto state_density = [&](int i) { return host.HostRows::at(i, particles.state_density_row); };
  const auto pressure = [&](int i) {
    return L::ThermalForm::pressure(host.template at<Thermal>(i), state_density(i), gamma);
  };
  Snapshot snapshot{
      .dimension = D, .box = box, .time = time, .step = step, .gamma = gamma, .id = host.ids, .fields = {}};
  auto& fields = snapshot.fields;
  const auto place_of = [&]<class F>(F) {
    return FieldPlace{&F::facts, component_offset<D, F, BaseFields>, components<F, D>};
  };
  fields.push_back(host.field(place_of(Position{})));
  for (std::size_t i = 0; i < snapshot.id.size(); ++i)
    for (int d = 0; d < D; ++d) {
      double& x = fields[0].values[3 * i + d];
      x = particles.tree.domain.wrapped(x, d);
    }
  fields.push_back(host.field(place_of(Velocity{})));
  fields.push_back(host.field(place_of(Mass{})));
  fields.push_back(host.field(place_of(Density{})));
  fields.push_back(host.scalar("InternalEnergies", "Specific thermal energy", {.length = 2, .time = -2},
                               [&](int i) { return pressure(i) / ((gamma - 1) * state_density(i)); }));
  fields.push_back(host.scalar(Pressure::facts.name, Pressure::facts.description, Pressure::facts.unit, pressure));
  fields.push_back(host.field(place_of(Support{})));
  fields.push_back(host.scalar(Entropy::facts.name, Entropy::facts.description, Entropy::facts.unit,
                               [&](int i) { return pressure(i) / std::pow(state_density(i), gamma); }));
  for (const FieldPlace& place : facts.fields)
    if (place.facts->shown == Shown::in_snapshots) fields.push_back(host.field(place));
  return snapshot;
}

/// Where particle i sits, into the report as what limits the time-step.
template <class L>
void note_limiting_particle(const Particles<L>& state, int i, StepReport& report) {
  if (i < 0) return;
  const auto one =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, Kokkos::subview(state.ids, std::pair(i, i + 1)));
  report.limiting_id = one(0);
  for (int d = 0; d < L::dimension; ++d) {
    const auto start = (component_offset<L::dimension, Position, typename L::Fields> + d) *
                           static_cast<std::size_t>(state.columns.stride) +
                       i;
    report.limiting_x[d] = on_host(Kokkos::subview(state.columns.data, std::pair(start, start + 1)))(0);
  }
}

}  // namespace sphk
