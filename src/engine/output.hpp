#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "kernels/passes/step_passes.hpp"
#include "src/engine/errors.hpp"
#include "src/engine/particle_set.hpp"
#include "src/engine/simulation.hpp"
#include "src/engine/totals.hpp"

namespace sphk {

/// Bytes of device memory per particle: the columns twice (the sort needs a second copy), neighbour counts, ids, sort
/// keys, cells.
template <class S>
inline constexpr double bytes_per_particle = 2.0 * sizeof(double) * Particles<typename S::Layout>::Columns::size + 8 +
                                             2 * 8 + 2 * 12 + sizeof(Bounds<S::dimension>) * (1.0 / 7);

/// The same for steps of the particles' own: begins, ends, their second copy and caps; masks and ranges of the cells.
inline constexpr double bytes_of_own_steps = 4 * sizeof(Ticks) + sizeof(TickRange) * (1.0 / 7) + 12.0 / cell_size;

/// Flops of one pair inside the support, loop by loop: distance, smoothing kernels, terms.
inline constexpr int flops_of_distance(int dimension) {
  return 3 * dimension + 1;
}
template <class S>
inline constexpr double flops_of_search = flops_of_distance(S::dimension) + 2 + S::Kernel::flops + 7;
template <class S>
inline constexpr double flops_of_density_terms =
    S::DensityTerms::List::size == 0 ? 0 : S::Kernel::flops + S::dimension + 5 + S::DensityTerms::flops;
/// The weight, the basis, one product and addition a moment and two products and an addition a right-hand side.
template <class S>
inline constexpr double flops_of_fit = flops_of_distance(S::dimension) + 2 * S::Kernel::flops + 8 + S::dimension +
                                       3 * Monomials<S::dimension>::basis + 2 * Monomials<S::dimension>::count
                                       + S::dimension*(2 * Monomials<S::dimension>::basis + 2);
template <class S>
inline constexpr double flops_of_rates = flops_of_distance(S::dimension) +
                                         2 * (S::Kernel::flops + S::dimension + 3) + S::RateTerms::flops + 4;

/// Flops of one pair in a step.
template <class S>
constexpr double flops_per_pair() {
  constexpr bool fits = contains<GradVelocityDivergence, typename S::Fields>;
  return flops_of_search<S> + flops_of_density_terms<S> + (fits ? flops_of_fit<S> : 0) + flops_of_rates<S>;
}

namespace detail {

inline HostNumbers on_host(const Numbers& numbers) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, numbers);
}

/// Columns on the host, with the order of ids.
template <class L>
struct HostColumns {
  static constexpr int D = L::dimension;
  using Fields = typename L::Fields;
  using Columns = typename Particles<L>::Columns;
  std::vector<int> order;
  HostNumbers data;
  std::size_t stride;
  Ids::HostMirror ids;

  explicit HostColumns(const Particles<L>& state)
      : order(state.n),
        data(on_host(state.columns.data)),
        stride(state.columns.stride),
        ids(Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.ids)) {
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return ids(a) < ids(b); });
  }
  /// Component k of field F of the particle that is i-th by id.
  template <class F>
  double at(int i, int k = 0) const {
    return data((component_offset<D, F, Fields> + k) * stride + order[i]);
  }
  /// A field as output: vectors padded to three components, a 2D curl in its z component.
  template <class F>
  Field field(std::string name, std::string description, UnitExponents units) const {
    constexpr int size = components<F, D>;
    constexpr bool is_vector = size > 1 || std::is_same_v<F, Position> || std::is_same_v<F, Velocity> ||
                               std::is_same_v<F, Acceleration> || std::is_same_v<F, VelocityCurl> ||
                               std::is_same_v<F, GradVelocityDivergence>;
    constexpr int first = std::is_same_v<F, VelocityCurl> && D < 3 ? 2 : 0;
    Field out{std::move(name), std::move(description), units, is_vector ? 3 : 1, {}};
    out.values.assign(order.size() * out.components, 0.0);
    for (std::size_t i = 0; i < order.size(); ++i)
      for (int k = 0; k < size; ++k)
        out.values[i * out.components + (is_vector ? first + k : 0)] = at<F>(static_cast<int>(i), k);
    return out;
  }
};

template <class L, class F>
Field scalar_field(const HostColumns<L>& host, std::string name, std::string description, UnitExponents units,
                   F value) {
  Field out{std::move(name), std::move(description), units, 1, std::vector<double>(host.order.size())};
  for (std::size_t i = 0; i < host.order.size(); ++i) out.values[i] = value(static_cast<int>(i));
  return out;
}

}  // namespace detail

/// The state on the host, sorted by id, positions wrapped into the box.
template <class L>
Snapshot take_snapshot(const Particles<L>& particles, const Box& box, double time, long step) {
  constexpr int D = L::dimension;
  const detail::HostColumns<L> host(particles);
  const double gamma = particles.parameters.gamma;
  const auto pressure = [&](int i) {
    return L::ThermalForm::pressure(host.template at<Thermal>(i), host.template at<Density>(i), gamma);
  };
  const UnitExponents density{-D, 1, 0}, energy{2, 0, -2};
  Snapshot snapshot{.dimension = D, .box = box, .time = time, .step = step, .gamma = gamma, .id = {}, .fields = {}};
  for (const int i : host.order) snapshot.id.push_back(host.ids(i));
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
  fields.push_back(detail::scalar_field(host, "InternalEnergies", "Specific thermal energy", energy, [&](int i) {
    return pressure(i) / ((gamma - 1) * host.template at<Density>(i));
  }));
  fields.push_back(detail::scalar_field(host, "Pressures", "Pressure", {2.0 - D, 1, -2}, pressure));
  fields.push_back(host.template field<Support>("SmoothingLength", "Support radius: W = 0 for r >= h", {1, 0, 0}));
  const UnitExponents entropy{2 + D * (gamma - 1), 1 - gamma, -2};
  fields.push_back(detail::scalar_field(host, "Entropies", "Entropy function A = P / rho^gamma", entropy, [&](int i) {
    return pressure(i) / std::pow(host.template at<Density>(i), gamma);
  }));
  if constexpr (contains<VelocityDivergence, typename L::Fields>)
    fields.push_back(host.template field<VelocityDivergence>("VelocityDivergence", "div v", {0, 0, -1}));
  if constexpr (contains<Alpha, typename L::Fields>)
    fields.push_back(
        host.template field<Alpha>("Alpha", "Dissipation switch (S12 eq 21-23), before Balsara's factor", {0, 0, 0}));
  if constexpr (contains<Balsara, typename L::Fields>)
    fields.push_back(host.template field<Balsara>("BalsaraFactors", "Balsara factor", {0, 0, 0}));
  return snapshot;
}

/// Throws NumericsError naming the particle when the next time-step is not positive.
void require_finite(const StepLimit& limit, double time, long step);

/// Throws NumericsError where a particle asks for less than the shortest step of the hierarchy.
void require_tick(const StepLimit& limit, const StepClock& clock, double time, long step);

/// Sentences on searches for h and fits that did not go as they should.
std::vector<std::string> warnings_of(const SupportCounts& searches, const FitCounts& fits);

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
    report.limiting_x[d] = detail::on_host(Kokkos::subview(state.columns.data, std::pair(start, start + 1)))(0);
  }
}

}  // namespace sphk
