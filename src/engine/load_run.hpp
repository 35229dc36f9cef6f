// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/schedule.hpp"
#include "kernels/passes/sorted_cells.hpp"
#include "src/engine/loading.hpp"
#include "src/engine/scheme_interface.hpp"

namespace sphk {

namespace detail {

/// A first support radius from the volume of each particle's cell: the searches start near their ends. One that comes
/// with the particles is not asked: no result may hang on it, nor the time that the search takes.
template <class L>
struct GuessSupport {
  Particles<L> state;
  double fallback;  ///< where a cell has no volume
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    constexpr int D = L::dimension;
    const int cell = i / cell_size;
    const Bounds<D>& b = state.tree.node(1, cell);
    const int held = min(cell_size, state.n - cell * cell_size);
    double longest = 0, volume = 1;
    for (int d = 0; d < D; ++d) longest = max(longest, b.hi[d] - b.lo[d]);
    for (int d = 0; d < D; ++d) volume *= max(b.hi[d] - b.lo[d], 0.1 * longest);
    const double h = Kokkos::pow(state.parameters.neighbours * volume / (held * unit_sphere<D>), 1.0 / D);
    state.template at<Support>(i) = min(h > 0 ? h : fallback, state.parameters.h_max);
  }
};

/// Turns the loaded specific energies into the scheme's thermal variable, with the standard density.
template <class L>
struct ThermalFromEnergy {
  Particles<L> state;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    double& s = state.template at<Thermal>(i);
    s = L::ThermalForm::from_energy(s, state.template at<Density>(i), state.parameters.gamma);
  }
};

/// Copies particles to the columns, with their specific energies as thermal variable.
template <class L>
void copy_to_columns(const Particles<L>& state, const ParticleSet& particles, const Scale& scale, int alpha_row) {
  constexpr int D = L::dimension;
  const auto stride = static_cast<std::size_t>(state.columns.stride);
  auto host = Kokkos::create_mirror_view(Kokkos::HostSpace{}, state.columns.data);
  auto ids = Kokkos::create_mirror_view(Kokkos::HostSpace{}, state.ids);
  const auto row = [&]<class F>(F, int component) {
    return host.data() + (component_offset<D, F, BaseFields> + component) * stride;
  };
  const double length = 1 / scale.factor(length_unit), speed = 1 / scale.factor(speed_unit),
               mass = 1 / scale.factor(mass_unit), specific_energy = 1 / scale.factor(specific_energy_unit);
  for (int i = 0; i < state.n; ++i) {
    for (int d = 0; d < D; ++d) {
      row(Position{}, d)[i] = length * particles.x[i][d];
      row(Velocity{}, d)[i] = speed * particles.v[i][d];
    }
    row(Mass{}, 0)[i] = mass * particles.m[i];
    row(Thermal{}, 0)[i] = specific_energy * particles.u[i];
    if (alpha_row >= 0) host(alpha_row * stride + i) = particles.alpha.empty() ? 0 : particles.alpha[i];
    ids(i) = particles.id.empty() ? static_cast<std::uint64_t>(i) + 1 : particles.id[i];
  }
  Kokkos::deep_copy(ExecutionSpace(), state.columns.data, host);
  Kokkos::deep_copy(ExecutionSpace(), state.ids, ids);
  ExecutionSpace().fence("load particles");
}

/// Room for steps of the particles' own; all of them are at the start of a block. Sorts then have memory of their own,
/// since particles that are not computed keep what they have; the caps are in its second row.
template <class L>
void allow_individual_steps(Run<L>& run, const SimulationSettings& settings) {
  Particles<L>& state = run.state;
  Schedule& schedule = run.schedule;
  const int n = state.n, stride = state.columns.stride;
  using Sorter = sphk::Sorter<L::dimension>;
  const ColumnNumbers memory("memory of sorts", static_cast<std::size_t>(Sorter::rows) * stride);
  run.sorter = Sorter(n, memory, stride);
  schedule.caps = Kokkos::View<int*, MemorySpace>(reinterpret_cast<int*>(memory.data() + stride), n);
  state.clock.individual = true;
  state.clock.begin = Kokkos::View<Ticks*, MemorySpace>("step begins", n);
  state.clock.end = Kokkos::View<Ticks*, MemorySpace>("step ends", n);
  state.clock.power = Kokkos::View<std::uint8_t*, MemorySpace>("powers of steps", n);
  const auto subset = [&](const std::string& label) {
    return ParticleSubset{.everyone = false,
                          .cell_numbers = Kokkos::View<int*, MemorySpace>(label + ", cells", state.tree.cells()),
                          .masks = Kokkos::View<TargetMask*, MemorySpace>(label, state.tree.cells())};
  };
  state.active = subset("active particles");
  state.active.everyone = true;
  for (ParticleSubset& capped : schedule.capped) capped = subset("capped particles");
  schedule.near = subset("near cells");
  schedule.near.everyone = true;
  state.clock.late = Kokkos::View<double*, MemorySpace>("late cells", state.tree.cells());
  schedule.ranges = Kokkos::View<StepRange*, MemorySpace>("ranges of steps", state.tree.first[state.tree.levels]);
  schedule.limiter = settings.step_limiter;
  if (settings.max_dt > 0) schedule.longest = settings.max_dt;
  Kokkos::deep_copy(ExecutionSpace(), schedule.caps, StepClock::block_bits);
}

}  // namespace detail

template <class L>
Run<L> load_run(const ParticleSet& given, const SimulationSettings& settings, const CompiledFacts& facts,
                const std::function<void(Run<L>&)>& find_supports) {
  constexpr int D = L::dimension;
  using Columns = typename Particles<L>::Columns;
  const int n = static_cast<int>(given.size());
  const Scale scale = settings.own_units.value_or(Scale{});
  const double length = 1 / scale.factor(length_unit);
  Domain<D> domain{};
  for (int d = 0; d < D; ++d) {
    domain.lower[d] = length * given.box.lower[d];
    domain.period[d] = given.box.periodic[d] ? length * given.box.size[d] : 0;
  }
  const int stride = Columns::padded(n);
  const ColumnNumbers rows("particles", static_cast<std::size_t>(facts.rows) * static_cast<std::size_t>(stride));
  Run<L> run(
      Particles<L>{n, Columns(rows, stride), Ids("ids", n), CellTree<D>(n, domain), parameters_of(given, settings)});
  run.state.state_density_row = facts.state_density_row;
  detail::copy_to_columns(run.state, given, scale, facts.alpha_row);
  run.time = given.time / scale.factor(time_unit);
  run.accept = facts.mixed ? 1e-4 : 1e-7;  // as near as the pair arithmetic can tell
  run.given = given_of(settings);
  run.state.parameters.courant /= facts.stiffness(run.given);
  run.state.central = CentralMass(run.given);
  run.state.clock.mobility = run.given[motion];
  if (has_own_steps(settings)) detail::allow_individual_steps(run, settings);
  fit_cells(run.state, {});
  sort_cells(run.state, run.sorter, run.schedule);
  const Kokkos::RangePolicy<ExecutionSpace> all(0, n);
  Kokkos::parallel_for("guess support", all,
                       detail::GuessSupport<L>{run.state, length * support_of_even_gas(given, settings)});
  find_supports(run);
  Kokkos::parallel_for("thermal from energy", all, detail::ThermalFromEnergy<L>{run.state});
  return run;
}

}  // namespace sphk
