#pragma once

#include <cmath>

#include "kernels/passes/step_passes.hpp"
#include "src/engine/particle_set.hpp"
#include "src/engine/simulation.hpp"

namespace sphk {

namespace detail {

/// A first support radius from the volume of each particle's cell: the searches start near their ends.
template <class L>
struct GuessSupport {
  Particles<L> state;
  double fallback;  ///< where a cell has no volume
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    constexpr int D = L::dimension;
    if (state.template at<Support>(i) > 0) return;
    const int cell = i / cell_size;
    const Bounds<D>& b = state.tree.node(1, cell);
    const int held = min(cell_size, state.n - cell * cell_size);
    double longest = 0, volume = 1;
    for (int d = 0; d < D; ++d) longest = max(longest, b.hi[d] - b.lo[d]);
    for (int d = 0; d < D; ++d) volume *= max(b.hi[d] - b.lo[d], 0.1 * longest);
    const double per_neighbour = volume / (held * unit_sphere<D>);
    const double h = Kokkos::pow(state.parameters.neighbours * per_neighbour, 1.0 / D);
    state.template at<Support>(i) = min(longest > 0 ? h : fallback, state.parameters.h_max);
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

template <class L>
void copy_to_columns(const Particles<L>& state, const ParticleSet& particles) {
  constexpr int D = L::dimension;
  auto host = Kokkos::create_mirror_view(Kokkos::HostSpace{}, state.columns.data);
  auto ids = Kokkos::create_mirror_view(Kokkos::HostSpace{}, state.ids);
  using C = typename Particles<L>::Columns;
  const auto row = [&]<class F>(F, int component) {
    return host.data() +
           (component_offset<D, F, typename C::Fields> + component) * static_cast<std::size_t>(state.columns.stride);
  };
  for (int i = 0; i < state.n; ++i) {
    for (int d = 0; d < D; ++d) {
      row(Position{}, d)[i] = particles.x[i][d];
      row(Velocity{}, d)[i] = particles.v[i][d];
    }
    row(Mass{}, 0)[i] = particles.m[i];
    row(Thermal{}, 0)[i] = particles.u[i];
    row(Support{}, 0)[i] = particles.h.empty() ? 0 : particles.h[i];
    if constexpr (contains<Alpha, typename C::Fields>)
      row(Alpha{}, 0)[i] = particles.alpha.empty() ? 0 : particles.alpha[i];
    ids(i) = particles.id.empty() ? static_cast<std::uint64_t>(i) + 1 : particles.id[i];
  }
  Kokkos::deep_copy(ExecutionSpace(), state.columns.data, host);
  Kokkos::deep_copy(ExecutionSpace(), state.ids, ids);
  ExecutionSpace().fence("load particles");
}

/// Room for steps of the particles' own; all of them are at the start of a block.
template <class S>
void allow_individual_steps(Run<S>& run, const SimulationSettings& settings) {
  auto& state = run.state;
  const int n = state.n;
  state.clock.individual = true;
  state.clock.begin = Kokkos::View<Ticks*, MemorySpace>("step begins", n);
  state.clock.end = Kokkos::View<Ticks*, MemorySpace>("step ends", n);
  state.active.masks = Kokkos::View<TargetMask*, MemorySpace>("active particles", state.tree.cells());
  state.active.cell_numbers = Kokkos::View<int*, MemorySpace>("active cells", state.tree.cells());
  run.schedule.caps = Kokkos::View<Ticks*, MemorySpace>("caps of steps", n);
  run.schedule.other = Kokkos::View<Ticks*, MemorySpace>("step times, other", n);
  run.schedule.ranges = Kokkos::View<TickRange*, MemorySpace>("ranges of steps", state.tree.first[state.tree.levels]);
  run.schedule.limiter = settings.step_limiter;
  if (settings.max_dt > 0) run.schedule.longest = settings.max_dt;
  Kokkos::deep_copy(ExecutionSpace(), run.schedule.caps, StepClock::block);
}

}  // namespace detail

/// The support radius if the particles filled their box evenly.
inline double support_of_even_gas(const ParticleSet& particles, const SimulationSettings& settings) {
  const int D = particles.dimension;
  double volume = 1;
  for (int d = 0; d < D; ++d) volume *= particles.box.size[d];
  const double sphere = D == 1 ? unit_sphere<1> : D == 2 ? unit_sphere<2> : unit_sphere<3>;
  return std::pow(settings.neighbours * volume / (static_cast<double>(particles.size()) * sphere), 1.0 / D);
}

/// Largest support radius of a run: the setting; or the box's diagonal where an axis is open; or, in a periodic box,
/// what the N_n-th image is nearer than wherever the particles are.
inline double support_cap(const ParticleSet& particles, const SimulationSettings& settings) {
  if (settings.h_max > 0) return settings.h_max;
  double diagonal2 = 0;
  bool open = false;
  for (int d = 0; d < particles.dimension; ++d) {
    diagonal2 += particles.box.size[d] * particles.box.size[d];
    open = open || !particles.box.periodic[d];
  }
  const double diagonal = std::sqrt(diagonal2);
  return open ? diagonal : diagonal + 2 * support_of_even_gas(particles, settings);
}

/// Particles on the device, sorted, with supports, densities and the scheme's thermal variable.
template <class S>
Run<S> load_run(const ParticleSet& particles, const SimulationSettings& settings, const typename S::Kernel& kernel) {
  constexpr int D = S::dimension;
  const int n = static_cast<int>(particles.size());
  Domain<D> domain{};
  for (int d = 0; d < D; ++d) {
    domain.lower[d] = particles.box.lower[d];
    domain.period[d] = particles.box.periodic[d] ? particles.box.size[d] : 0;
  }
  const Parameters parameters{.neighbours = settings.neighbours,
                              .gamma = settings.gamma,
                              .courant = settings.courant,
                              .alpha = settings.viscosity_alpha,
                              .beta = settings.viscosity_beta,
                              .subtract_E0 = settings.scheme == "sphs-morris",
                              .alpha_entropy = settings.alpha_entropy,
                              .alpha_mass = settings.alpha_mass,
                              .alpha_min = settings.alpha_min,
                              .noise = settings.switch_noise,
                              .alpha_given = settings.alpha_given,
                              .balsara_limits_all = settings.balsara_limits_all,
                              .mass_correction = settings.mass_correction,
                              .h_max = support_cap(particles, settings)};
  using Columns = typename Particles<typename S::Layout>::Columns;
  Run<S> run{State<S>{{n, Columns("particles", n), Ids("ids", n), CellTree<D>(n, domain), parameters},
                      Smoothing<typename S::Kernel, D>(kernel)}};
  run.sorter = Sorter<D, Columns>(n);
  run.time = particles.time;
  run.accept = std::is_same_v<typename S::PairNumber, float> ? 1e-4 : 1e-7;
  detail::copy_to_columns<typename S::Layout>(run.state, particles);
  if (settings.individual_steps) detail::allow_individual_steps(run, settings);
  SortedCells::run(run);
  const Kokkos::RangePolicy<ExecutionSpace> all(0, n);
  Kokkos::parallel_for("guess support", all,
                       detail::GuessSupport<typename S::Layout>{run.state, support_of_even_gas(particles, settings)});
  SmoothingLength::run(run);
  Kokkos::parallel_for("thermal from energy", all, detail::ThermalFromEnergy<typename S::Layout>{run.state});
  return run;
}

}  // namespace sphk
