#pragma once

#include "kernels/terms/density.hpp"
#include "kernels/terms/signal_velocity.hpp"
#include "src/engine/output.hpp"

namespace sphk {

namespace detail {

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

/// The sums of `Terms` over symmetric pairs, apart from the state.
template <class Terms, class S>
Columns<S::dimension, typename Terms::Adds> sums_apart(const State<S>& state) {
  Columns<S::dimension, typename Terms::Adds> out("diagnostics", state.n);
  add_pair_rates(state, Terms(state.parameters), out);
  return out;
}

}  // namespace detail
}  // namespace sphk

template <>
struct Kokkos::reduction_identity<sphk::detail::CountRange> {
  KOKKOS_FORCEINLINE_FUNCTION static sphk::detail::CountRange sum() { return {}; }
};

namespace sphk {

/// True neighbours, r < h_i, self included: minimum, mean and maximum into the report.
template <class S>
void count_neighbours(const State<S>& state, StepReport& report) {
  if (state.n == 0) return;
  const auto counts = detail::sums_apart<TermSet<NeighbourCountSum>>(state);
  detail::CountRange range;
  Kokkos::parallel_reduce("neighbour counts", Kokkos::RangePolicy<ExecutionSpace>(0, state.n),
                          detail::RangeOfCounts<std::remove_const_t<decltype(counts)>>{counts},
                          Kokkos::Sum<detail::CountRange>(range));
  report.min_neighbours = range.lowest;
  report.max_neighbours = range.highest;
  report.mean_neighbours = range.sum / state.n;
}

namespace detail {

/// Appends what a set of columns holds for field F to `fields`, in the order of ids.
template <class F, class S, class C>
Field apart_field(const HostColumns<S>& host, const C& columns, std::string name, std::string description,
                  UnitExponents units) {
  constexpr int size = components<F, S::dimension>;
  const auto data = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, columns.data);
  const bool is_vector = std::is_same_v<F, ErrorE0> || std::is_same_v<F, Acceleration>;
  Field out{std::move(name), std::move(description), units, is_vector ? 3 : 1, {}};
  out.values.assign(host.order.size() * out.components, 0.0);
  for (std::size_t i = 0; i < host.order.size(); ++i)
    for (int k = 0; k < size; ++k)
      out.values[i * out.components + k] =
          data(component_offset<S::dimension, F, typename C::Fields> + k, host.order[i]);
  return out;
}

template <class S, class... Term>
void append_split(std::vector<Field>& fields, const HostColumns<S>& host, const State<S>& state, List<Term...>) {
  const auto append = [&]<class T>() {
    if constexpr (requires { T::label; }) {
      const auto sums = sums_apart<TermSet<T>>(state);
      const std::string what = std::string(" by the ") + T::name;
      if constexpr (contains<Acceleration, typename T::Adds>)
        fields.push_back(apart_field<Acceleration>(host, sums, std::string("Acceleration") + T::label,
                                                   "dv/dt" + what, {1, 0, -2}));
      if constexpr (contains<Heating, typename T::Adds>)
        fields.push_back(
            apart_field<Heating>(host, sums, std::string("Heating") + T::label, "du/dt" + what, {2, 0, -3}));
    }
  };
  (append.template operator()<Term>(), ...);
}

}  // namespace detail

/// One right-hand side, as `sphk rates` writes it; the passes have just been run.
template <class S>
std::vector<Field> take_rates(const Run<S>& run, bool split) {
  constexpr int D = S::dimension;
  const detail::HostColumns<S> host(run.state);
  const double gamma = run.state.parameters.gamma;
  std::vector<Field> fields;
  fields.push_back(host.template field<Support>("SmoothingLength", "Support radius: W = 0 for r >= h", {1, 0, 0}));
  fields.push_back(host.template field<Density>("Density", "Density, sum of m_j W(r_ij, h_i)", {-D, 1, 0}));
  fields.push_back(host.template field<VelocityDivergence>("VelocityDivergence", "div v", {0, 0, -1}));
  fields.push_back(host.template field<VelocityCurl>("VelocityCurl", "curl v", {0, 0, -1}));
  fields.push_back(host.template field<Acceleration>("Acceleration", "dv/dt of all terms", {1, 0, -2}));
  const UnitExponents entropy_rate{2 + D * (gamma - 1), 1 - gamma, -3};
  fields.push_back(detail::scalar_field(host, "EntropyRate", "dA/dt of all terms", entropy_rate, [&](int i) {
    const double rho = host.template at<Density>(i);
    const double P = S::ThermalForm::pressure(host.template at<Thermal>(i), rho, gamma);
    const double work = -P / rho * host.template at<VelocityDivergence>(i);
    return S::ThermalForm::entropy_rate(host.template at<ThermalRate>(i), work, rho, gamma);
  }));
  const auto sums = detail::sums_apart<TermSet<NeighbourCountSum, ZerothOrderError>>(run.state);
  fields.push_back(detail::apart_field<NeighbourCount>(host, sums, "NeighbourCount", "Neighbours with r < h, self included",
                                                       {}));
  fields.push_back(detail::apart_field<ErrorE0>(host, sums, "E0", "Zeroth-order force error (S12 eq 13)", {}));
  if (split) detail::append_split(fields, host, run.state, typename S::RateTerms::List{});
  return fields;
}

}  // namespace sphk
