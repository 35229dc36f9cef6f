// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/host_columns.hpp"
#include "src/engine/scheme_interface.hpp"

namespace sphk {

/// In the run's own order.
template <class L>
std::vector<std::uint64_t> ids_of(const Particles<L>& particles) {
  const auto ids = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, particles.ids);
  return {ids.data(), ids.data() + ids.extent(0)};
}

/// The fields of snapshots that are rows of the columns.
template <class L>
HeldParticles held_in(const Particles<L>& particles, const CompiledFacts& facts) {
  const auto rows = std::make_shared<HostNumbers>(on_host(particles.columns.data));
  const auto stride = static_cast<std::size_t>(particles.columns.stride);
  HeldParticles held{ids_of(particles), {}, rows};
  const auto hold = [&](const FieldPlace& place) {
    held.fields.push_back({.name = place.facts->name,
                           .units = exponents(place.facts->unit, L::dimension, particles.parameters.gamma),
                           .components = place.components,
                           .data = rows->data() + static_cast<std::size_t>(place.row) * stride,
                           .stride = stride});
  };
  for_each_type(List<Position, Velocity, Mass, Density, Support>{}, [&]<class F>() {
    hold({&F::facts, component_offset<L::dimension, F, BaseFields>, components<F, L::dimension>});
  });
  for (const FieldPlace& place : facts.fields)
    if (place.facts->shown == Shown::in_snapshots) hold(place);
  return held;
}

}  // namespace sphk
