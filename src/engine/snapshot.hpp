// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/host_columns.hpp"
#include "src/engine/scheme_interface.hpp"

namespace sphk {

namespace detail {

/// A field of one component, value(i) for the particle that is i-th by id, made when it is asked for.
template <class Value>
Field scalar_of(const std::shared_ptr<const HostRows>& rows, const char* name, const char* description,
                const Unit& unit, const Value& value) {
  return {name, description, exponents(unit, rows->dimension, rows->gamma), 1, {}, [rows, value] {
            std::vector<double> values(rows->order.size());
            for (std::size_t i = 0; i < values.size(); ++i) values[i] = value(static_cast<int>(i));
            return values;
          }};
}

}  // namespace detail

/// The state on the host, sorted by id, positions wrapped into the box; fields make their values when they are asked
/// for.
template <class L>
Snapshot view_of(const Particles<L>& particles, const CompiledFacts& facts, const Box& box, double time, long step) {
  constexpr int D = L::dimension;
  const auto host = std::make_shared<HostColumns<L>>(particles);
  const double gamma = particles.parameters.gamma;
  const auto rho = [rows = host.get(), row = particles.state_density_row](int i) { return rows->HostRows::at(i, row); };
  const auto pressure = [rows = host.get(), rho, gamma](int i) {
    return L::ThermalForm::pressure(rows->template at<Thermal>(i), rho(i), gamma);
  };
  Snapshot snapshot{.dimension = D,
                    .box = box,
                    .time = time,
                    .step = step,
                    .gamma = gamma,
                    .id = std::exchange(host->ids, {}),
                    .fields = {}};
  auto& fields = snapshot.fields;
  const auto field_of = [&]<class F>(F) {
    return HostRows::field_of(host, {&F::facts, component_offset<D, F, BaseFields>, components<F, D>});
  };
  fields = {field_of(Position{}), field_of(Velocity{}), field_of(Mass{}), field_of(Density{})};
  fields[0].make = [make = std::move(fields[0].make), domain = particles.tree.domain] {
    std::vector<double> x = make();
    for (std::size_t i = 0; i < x.size(); i += 3)
      for (int d = 0; d < D; ++d) x[i + d] = domain.wrapped(x[i + d], d);
    return x;
  };
  fields.push_back(detail::scalar_of(host, "InternalEnergies", "Specific thermal energy", {.length = 2, .time = -2},
                                     [=](int i) { return pressure(i) / ((gamma - 1) * rho(i)); }));
  fields.push_back(
      detail::scalar_of(host, Pressure::facts.name, Pressure::facts.description, Pressure::facts.unit, pressure));
  fields.push_back(field_of(Support{}));
  fields.push_back(detail::scalar_of(host, Entropy::facts.name, Entropy::facts.description, Entropy::facts.unit,
                                     [=](int i) { return pressure(i) / std::pow(rho(i), gamma); }));
  for (const FieldPlace& place : facts.fields)
    if (place.facts->shown == Shown::in_snapshots) fields.push_back(HostRows::field_of(host, place));
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
