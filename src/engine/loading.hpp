#pragma once

#include "src/engine/base.hpp"

namespace sphk {

/// The support radius if the particles filled their box evenly.
double support_of_even_gas(const ParticleSet& particles, const SimulationSettings& settings);

/// Largest support radius of a run: the setting; or the box's diagonal where an axis is open; or, in a periodic box,
/// what the N_n-th image is nearer than wherever the particles are.
double support_cap(const ParticleSet& particles, const SimulationSettings& settings);

/// The numbers that passes and terms read.
Parameters parameters_of(const ParticleSet& particles, const SimulationSettings& settings);

/// Particles as they are given, in columns.
template <class L>
Particles<L> load_particles(const ParticleSet& given, const SimulationSettings& settings) {
  constexpr int D = L::dimension;
  const int n = static_cast<int>(given.size());
  Domain<D> domain{};
  for (int d = 0; d < D; ++d) {
    domain.lower[d] = given.box.lower[d];
    domain.period[d] = given.box.periodic[d] ? given.box.size[d] : 0;
  }
  const Particles<L> particles{n, typename Particles<L>::Columns("particles", n), Ids("ids", n),
                               CellTree<D>(n, domain), parameters_of(given, settings)};
  copy_to_columns(particles.template front<BaseLayout<L>>(), given);
  if constexpr (contains<Alpha, typename L::Fields>)
    if (!given.alpha.empty())
      Kokkos::deep_copy(Kokkos::View<double*, MemorySpace, Kokkos::MemoryUnmanaged>(
                            particles.columns.template row<Alpha>(), given.alpha.size()),
                        Kokkos::View<const double*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged>(given.alpha.data(),
                                                                                               given.alpha.size()));
  return particles;
}

/// Particles on the device, sorted, with supports, densities and the scheme's thermal variable. `accept`: how near a
/// search for h must come; `find_supports(run)` runs the pass for them.
template <class L, class FindSupports>
Run<L> load_run(const ParticleSet& particles, const SimulationSettings& settings, double accept,
                const FindSupports& find_supports) {
  Run<L> run(load_particles<L>(particles, settings));
  run.time = particles.time;
  run.accept = accept;
  if (settings.individual_steps) {
    auto base = run.state.template front<BaseLayout<L>>();
    allow_individual_steps(base, run.schedule, settings);
    run.state.adopt(base);
  }
  SortedCells::run(run);
  const auto base = run.state.template front<BaseLayout<L>>();
  guess_supports(base, support_of_even_gas(particles, settings));
  find_supports(run);
  thermal_from_energy(base);
  return run;
}

/// How near the first searches for h must come to their roots: to what the pair arithmetic can tell.
template <class S>
inline constexpr double first_accept = std::is_same_v<typename S::PairNumber, float> ? 1e-4 : 1e-7;

template <class S>
Run<typename S::Layout> load_run(const ParticleSet& particles, const SimulationSettings& settings,
                                 const SmoothingOf<S>& smoothing) {
  return load_run<typename S::Layout>(particles, settings, first_accept<S>,
                                      [&](auto& run) { SmoothingLength::run<S>(run, smoothing); });
}

}  // namespace sphk
