#pragma once

#include "kernels/terms/apart.hpp"
#include "kernels/terms/neighbour_count.hpp"
#include "src/engine/host_columns.hpp"
#include "src/engine/output.hpp"

namespace sphk {

namespace detail {

/// The sums of `Terms` over symmetric pairs, apart from the state.
template <class Terms, class S>
auto sums_apart(const State<S>& state) {
  Columns<S::dimension, typename Terms::Adds> out("diagnostics", state.n);
  add_pair_sums("diagnostics", state, Terms(state.parameters), out);
  return out;
}

/// Appends what a set of columns holds for field F to `fields`, in the order of ids.
template <class F, class L, class C>
Field apart_field(const HostColumns<L>& host, const C& columns, std::string name, std::string description,
                  UnitExponents units, bool is_vector) {
  HostRows sums = host;
  sums.data = on_host(columns.data);
  sums.stride = static_cast<std::size_t>(columns.stride);
  constexpr int D = L::dimension;
  return sums.field(std::move(name), std::move(description), units, is_vector ? 3 : 1,
                    component_offset<D, F, typename C::Fields>, components<F, D>, 0);
}

/// What term T adds, as fields named after it: AccelerationViscosity, HeatingViscosity, ...
template <class T, class L, class C>
void append_apart(std::vector<Field>& fields, const HostColumns<L>& host, const C& sums) {
  if constexpr (requires { T::label; }) {
    const std::string what = std::string(" by the ") + T::name;
    if constexpr (contains<Acceleration, typename T::Adds>)
      fields.push_back(apart_field<ApartAcceleration<T>>(host, sums, std::string("Acceleration") + T::label,
                                                         "dv/dt" + what, {1, 0, -2}, true));
    if constexpr (contains<Heating, typename T::Adds>)
      fields.push_back(apart_field<ApartHeating<T>>(host, sums, std::string("Heating") + T::label, "du/dt" + what,
                                                    {2, 0, -3}, false));
  }
}

/// The terms of a scheme, each adding to fields of its own, with the diagnostics of `sphk rates`.
template <class... Term>
auto apart_terms(List<Term...>) -> TermSet<Apart<Term>..., NeighbourCountSum>;

}  // namespace detail

/// The sums of a scheme's terms, each apart, with the diagnostics of `sphk rates`; the passes have just been run.
template <class S>
auto sums_of_rates(const State<S>& state) {
  return detail::sums_apart<decltype(detail::apart_terms(typename S::RateTerms::List{}))>(state);
}

/// One right-hand side, as `sphk rates` writes it, of the terms of a list, with their sums apart.
template <class Terms, class L, class C>
std::vector<Field> rate_fields(const Particles<L>& state, const C& sums, bool split) {
  constexpr int D = L::dimension;
  using Form = typename L::ThermalForm;
  using Fields = typename L::Fields;
  const HostColumns<L> host(state);
  const double gamma = state.parameters.gamma;
  std::vector<Field> fields;
  fields.push_back(host.template field<Support>("SmoothingLength", "Support radius: W = 0 for r >= h", {1, 0, 0}));
  fields.push_back(host.template field<Density>("Density", "Density, sum of m_j W(r_ij, h_i)", {-D, 1, 0}));
  fields.push_back(host.template field<VelocityDivergence>("VelocityDivergence", "div v", {0, 0, -1}));
  fields.push_back(host.template field<VelocityCurl>("VelocityCurl", "curl v", {0, 0, -1}));
  fields.push_back(host.template field<Acceleration>("Acceleration", "dv/dt of all terms", {1, 0, -2}));
  const UnitExponents entropy_rate{2 + D * (gamma - 1), 1 - gamma, -3};
  fields.push_back(host.scalar("EntropyRate", "dA/dt of all terms", entropy_rate, [&](int i) {
    const double rho = host.HostRows::at(i, state.state_density_row);
    const double work =
        -Form::pressure(host.template at<Thermal>(i), rho, gamma) / rho * host.template at<VelocityDivergence>(i);
    return Form::entropy_rate(host.template at<ThermalRate>(i), work, rho, gamma);
  }));
  if constexpr (contains<GradVelocityDivergence, Fields>) {
    fields.push_back(host.template field<GradVelocityDivergence>("GradVelocityDivergence", "grad(div v)", {-1, 0, -1}));
    fields.push_back(host.scalar("AlphaLoc", "alpha_loc of S12 eq 21", {}, [&](int i) {
      double grad2 = 0;
      for (int d = 0; d < D; ++d) grad2 += std::pow(host.template at<GradVelocityDivergence>(i, d), 2);
      return detail::local_alpha(host.template at<Support>(i), host.template at<VelocityDivergence>(i),
                                 std::sqrt(grad2), state.parameters.noise * host.template at<SoundSpeed>(i));
    }));
  }
  if constexpr (contains<GeneralDensity, Fields>)
    fields.push_back(host.template field<GeneralDensity>("GeneralDensity", "Density of R10 eq 19", {-D, 1, 0}));
  if constexpr (contains<MassRate, Fields>)
    fields.push_back(host.template field<MassRate>("MassRate", "dm/dt by mass dissipation", {0, 1, -1}));
  fields.push_back(detail::apart_field<NeighbourCount>(host, sums, "NeighbourCount",
                                                       "Neighbours with r < h, self included", {}, false));
  if (split) for_each_type(Terms{}, [&]<class T>() { detail::append_apart<T>(fields, host, sums); });
  return fields;
}

}  // namespace sphk
