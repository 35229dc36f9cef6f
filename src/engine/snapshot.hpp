#pragma once

#include "src/engine/host_columns.hpp"
#include "src/engine/scheme_interface.hpp"

namespace sphk {

/// The state on the host, sorted by id, positions wrapped into the box.
template <class L>
Snapshot take_snapshot(const Particles<L>& particles, const SchemeFacts& facts, const Box& box, double time,
                       long step) {
  constexpr int D = L::dimension;
  const HostColumns<L> host(particles);
  const double gamma = particles.parameters.gamma;
  const auto state_density = [&](int i) { return host.HostRows::at(i, particles.state_density_row); };
  const auto pressure = [&](int i) {
    return L::ThermalForm::pressure(host.template at<Thermal>(i), state_density(i), gamma);
  };
  const UnitExponents density{-D, 1, 0}, energy{2, 0, -2};
  Snapshot snapshot{
      .dimension = D, .box = box, .time = time, .step = step, .gamma = gamma, .id = host.ids, .fields = {}};
  auto& fields = snapshot.fields;
  fields.push_back(host.template field<Position>("Coordinates", "Position", {1, 0, 0}));
  for (std::size_t i = 0; i < snapshot.id.size(); ++i)
    for (int d = 0; d < D; ++d) {
      double& x = fields[0].values[3 * i + d];
      x = particles.tree.domain.wrapped(x, d);
    }
  fields.push_back(host.template field<Velocity>("Velocities", "Velocity", {1, 0, -1}));
  fields.push_back(host.template field<Mass>("Masses", "Mass", {0, 1, 0}));
  fields.push_back(host.template field<Density>("Densities", "Density, sum of m_j W(r_ij, h_i)", density));
  fields.push_back(host.scalar("InternalEnergies", "Specific thermal energy", energy,
                               [&](int i) { return pressure(i) / ((gamma - 1) * state_density(i)); }));
  fields.push_back(host.scalar("Pressures", "Pressure", {2.0 - D, 1, -2}, pressure));
  fields.push_back(host.template field<Support>("SmoothingLength", "Support radius: W = 0 for r >= h", {1, 0, 0}));
  const UnitExponents entropy{2 + D * (gamma - 1), 1 - gamma, -2};
  fields.push_back(host.scalar("Entropies", "Entropy function A = P / rho^gamma", entropy,
                               [&](int i) { return pressure(i) / std::pow(state_density(i), gamma); }));
  for (const ShownColumn& column : facts.shown)
    fields.push_back(host.HostRows::field(column.name, column.description, column.units, 1, column.row, 1, 0));
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
