#pragma once

#include "kernels/passes/schedule.hpp"
#include "kernels/passes/sorted_cells.hpp"
#include "kernels/smoothing/johnson.hpp"
#include "kernels/terms/neighbour_count.hpp"
#include "src/engine/base.hpp"
#include "src/engine/loading.hpp"
#include "src/engine/output.hpp"

namespace sphk::detail {

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

/// Sums and extremes over particles, as a reduction.
struct TotalsSum {
  double mass = 0, kinetic = 0, thermal = 0;
  double p[3] = {0, 0, 0}, L[3] = {0, 0, 0};
  double max_speed2 = 0;
  double lowest[3] = {1e300, 1e300, 1e300};  ///< of rho, P, A
  double highest[3] = {0, 0, 0};

  KOKKOS_INLINE_FUNCTION TotalsSum& operator+=(const TotalsSum& b) {
    mass += b.mass;
    kinetic += b.kinetic;
    thermal += b.thermal;
    max_speed2 = max(max_speed2, b.max_speed2);
    for (int k = 0; k < 3; ++k) {
      p[k] += b.p[k];
      L[k] += b.L[k];
      lowest[k] = min(lowest[k], b.lowest[k]);
      highest[k] = max(highest[k], b.highest[k]);
    }
    return *this;
  }
};

template <class L>
struct SumTotals {
  Particles<L> state;
  KOKKOS_INLINE_FUNCTION void operator()(int i, TotalsSum& sum) const {
    constexpr int D = L::dimension;
    const double gamma = state.parameters.gamma, m = state.template at<Mass>(i), rho = state.template at<Density>(i);
    const double P = L::ThermalForm::pressure(state.template at<Thermal>(i), rho, gamma);
    double x[3] = {0, 0, 0}, v[3] = {0, 0, 0};
    for (int d = 0; d < D; ++d) x[d] = state.template at<Position>(i, d), v[d] = state.template at<Velocity>(i, d);
    const double v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    TotalsSum one;
    one.mass = m;
    one.kinetic = 0.5 * m * v2;
    one.thermal = m * P / ((gamma - 1) * rho);
    one.max_speed2 = v2;
    for (int k = 0; k < 3; ++k) {
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      one.p[k] = m * v[k];
      one.L[k] = m * (x[a] * v[b] - x[b] * v[a]);
    }
    const double values[3] = {rho, P, P / Kokkos::pow(rho, gamma)};
    for (int k = 0; k < 3; ++k) one.lowest[k] = one.highest[k] = values[k];
    sum += one;
  }
};

struct CountRange {
  double lowest = 1e300, highest = 0, sum = 0;
  KOKKOS_INLINE_FUNCTION CountRange& operator+=(const CountRange& b) {
    lowest = min(lowest, b.lowest);
    highest = max(highest, b.highest);
    sum += b.sum;
    return *this;
  }
};

template <class C>
struct RangeOfCounts {
  C columns;
  KOKKOS_INLINE_FUNCTION void operator()(int i, CountRange& range) const {
    const double count = columns.template at<NeighbourCount>(i);
    range += {count, count, count};
  }
};

/// A pair loop that needs no smoothing kernel; any serves.
template <class L>
struct Counting {
  static constexpr int dimension = L::dimension;
  using Layout = L;
  using Kernel = Johnson;
  using PairNumber = float;
};

template <class L>
void copy_to_columns(const Particles<L>& state, const ParticleSet& particles, int alpha_row) {
  constexpr int D = L::dimension;
  const auto stride = static_cast<std::size_t>(state.columns.stride);
  auto host = Kokkos::create_mirror_view(Kokkos::HostSpace{}, state.columns.data);
  auto ids = Kokkos::create_mirror_view(Kokkos::HostSpace{}, state.ids);
  const auto row = [&]<class F>(F, int component) {
    return host.data() + (component_offset<D, F, BaseFields> + component) * stride;
  };
  for (int i = 0; i < state.n; ++i) {
    for (int d = 0; d < D; ++d) {
      row(Position{}, d)[i] = particles.x[i][d];
      row(Velocity{}, d)[i] = particles.v[i][d];
    }
    row(Mass{}, 0)[i] = particles.m[i];
    row(Thermal{}, 0)[i] = particles.u[i];
    row(Support{}, 0)[i] = particles.h.empty() ? 0 : particles.h[i];
    if (alpha_row >= 0) host(alpha_row * stride + i) = particles.alpha.empty() ? 0 : particles.alpha[i];
    ids(i) = particles.id.empty() ? static_cast<std::uint64_t>(i) + 1 : particles.id[i];
  }
  Kokkos::deep_copy(ExecutionSpace(), state.columns.data, host);
  Kokkos::deep_copy(ExecutionSpace(), state.ids, ids);
  ExecutionSpace().fence("load particles");
}

template <class L>
void allow_individual_steps(Particles<L>& state, Schedule& schedule, const SimulationSettings& settings) {
  const int n = state.n;
  state.clock.individual = true;
  state.clock.begin = Kokkos::View<Ticks*, MemorySpace>("step begins", n);
  state.clock.end = Kokkos::View<Ticks*, MemorySpace>("step ends", n);
  state.active.masks = Kokkos::View<TargetMask*, MemorySpace>("active particles", state.tree.cells());
  state.active.cell_numbers = Kokkos::View<int*, MemorySpace>("active cells", state.tree.cells());
  schedule.caps = Kokkos::View<Ticks*, MemorySpace>("caps of steps", n);
  schedule.other = Kokkos::View<Ticks*, MemorySpace>("step times, other", n);
  schedule.ranges = Kokkos::View<TickRange*, MemorySpace>("ranges of steps", state.tree.first[state.tree.levels]);
  schedule.limiter = settings.step_limiter;
  if (settings.max_dt > 0) schedule.longest = settings.max_dt;
  Kokkos::deep_copy(ExecutionSpace(), schedule.caps, StepClock::block);
}

template <class L>
Snapshot take_snapshot(const Particles<L>& particles, const SchemeFacts& facts, const Box& box, double time,
                       long step) {
  constexpr int D = L::dimension;
  const HostColumns<L> host(particles);
  const double gamma = particles.parameters.gamma;
  const auto pressure = [&](int i) {
    return L::ThermalForm::pressure(host.template at<Thermal>(i), host.template at<Density>(i), gamma);
  };
  const UnitExponents density{-D, 1, 0}, energy{2, 0, -2};
  Snapshot snapshot{.dimension = D, .box = box, .time = time, .step = step, .gamma = gamma, .id = host.ids, .fields = {}};
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
  fields.push_back(host.scalar("InternalEnergies", "Specific thermal energy", energy, [&](int i) {
    return pressure(i) / ((gamma - 1) * host.template at<Density>(i));
  }));
  fields.push_back(host.scalar("Pressures", "Pressure", {2.0 - D, 1, -2}, pressure));
  fields.push_back(host.template field<Support>("SmoothingLength", "Support radius: W = 0 for r >= h", {1, 0, 0}));
  const UnitExponents entropy{2 + D * (gamma - 1), 1 - gamma, -2};
  fields.push_back(host.scalar("Entropies", "Entropy function A = P / rho^gamma", entropy, [&](int i) {
    return pressure(i) / std::pow(host.template at<Density>(i), gamma);
  }));
  for (const ShownColumn& column : facts.shown)
    fields.push_back(host.HostRows::field(column.name, column.description, column.units, 1, column.row, 1, 0));
  return snapshot;
}

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

}  // namespace sphk::detail

template <>
struct Kokkos::reduction_identity<sphk::detail::TotalsSum> {
  KOKKOS_FORCEINLINE_FUNCTION static sphk::detail::TotalsSum sum() { return {}; }
};

template <>
struct Kokkos::reduction_identity<sphk::detail::CountRange> {
  KOKKOS_FORCEINLINE_FUNCTION static sphk::detail::CountRange sum() { return {}; }
};

namespace sphk {

template <class L>
Run<L> load_run(const ParticleSet& given, const SimulationSettings& settings, const SchemeFacts& facts,
                const std::function<void(Run<L>&)>& find_supports) {
  constexpr int D = L::dimension;
  using Columns = typename Particles<L>::Columns;
  const int n = static_cast<int>(given.size());
  Domain<D> domain{};
  for (int d = 0; d < D; ++d) {
    domain.lower[d] = given.box.lower[d];
    domain.period[d] = given.box.periodic[d] ? given.box.size[d] : 0;
  }
  const int stride = Columns::padded(n);
  const Numbers rows("particles", static_cast<std::size_t>(facts.rows) * static_cast<std::size_t>(stride));
  Run<L> run(Particles<L>{n, Columns(rows, stride), Ids("ids", n), CellTree<D>(n, domain),
                          parameters_of(given, settings)});
  detail::copy_to_columns(run.state, given, facts.alpha_row);
  run.time = given.time;
  run.accept = facts.mixed ? 1e-4 : 1e-7;  // as near as the pair arithmetic can tell
  if (settings.individual_steps) detail::allow_individual_steps(run.state, run.schedule, settings);
  sort_cells(run.state, run.sorter, run.schedule, run.step);
  const Kokkos::RangePolicy<ExecutionSpace> all(0, n);
  Kokkos::parallel_for("guess support", all,
                       detail::GuessSupport<L>{run.state, support_of_even_gas(given, settings)});
  find_supports(run);
  Kokkos::parallel_for("thermal from energy", all, detail::ThermalFromEnergy<L>{run.state});
  return run;
}

template <class L>
void count_neighbours(const Particles<L>& particles, const CountColumns<L::dimension>& counts, StepReport& report) {
  const State<detail::Counting<L>> state{particles, Smoothing<Johnson, L::dimension>(Johnson{})};
  add_pair_sums("neighbour counts", state, TermSet<NeighbourCountSum>(particles.parameters), counts);
  detail::CountRange range;
  Kokkos::parallel_reduce("neighbour counts", Kokkos::RangePolicy<ExecutionSpace>(0, particles.n),
                          detail::RangeOfCounts<CountColumns<L::dimension>>{counts},
                          Kokkos::Sum<detail::CountRange>(range));
  report.min_neighbours = range.lowest;
  report.max_neighbours = range.highest;
  report.mean_neighbours = range.sum / particles.n;
}

template <class L>
Totals totals(const Particles<L>& state) {
  detail::TotalsSum sum;
  if (state.n > 0)
    Kokkos::parallel_reduce("totals", Kokkos::RangePolicy<ExecutionSpace>(0, state.n), detail::SumTotals<L>{state},
                            Kokkos::Sum<detail::TotalsSum>(sum));
  Totals totals;
  totals.mass = sum.mass;
  totals.kinetic = sum.kinetic;
  totals.thermal = sum.thermal;
  totals.max_speed = std::sqrt(sum.max_speed2);
  for (int k = 0; k < 3; ++k) totals.momentum[k] = sum.p[k], totals.angular_momentum[k] = sum.L[k];
  totals.min_density = sum.lowest[0], totals.max_density = sum.highest[0];
  totals.min_pressure = sum.lowest[1], totals.max_pressure = sum.highest[1];
  totals.min_entropy = sum.lowest[2], totals.max_entropy = sum.highest[2];
  return totals;
}

}  // namespace sphk
