// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/terms/apart.hpp"
#include "kernels/terms/neighbour_count.hpp"
#include "src/engine/host_columns.hpp"
#include "src/engine/output.hpp"

namespace sphk {

/// The share of one term in a field: where it is, and which term's.
struct TermShare {
  FieldPlace place;
  const char* label;  ///< appended to the field's name
  const char* term;
};

namespace detail {

/// The terms of a scheme, each adding to fields of its own, with the diagnostics of `sphk rates`.
template <class... Term>
auto apart_terms(List<Term...>) -> TermSet<Apart<Term>..., NeighbourCountSum>;

/// What term T adds to the fields of C, the columns of all terms' shares.
template <class T, class C>
void append_shares(std::vector<TermShare>& shares) {
  if constexpr (requires { T::label; })
    for_each_type(typename Apart<T>::Adds{}, [&]<class F>() {
      if constexpr (is_apart<F>)
        shares.push_back(
            {{&F::facts, component_offset<C::dimension, F, typename C::Fields>, components<F, C::dimension>},
             T::label,
             T::name});
    });
}

}  // namespace detail

/// The sums of a scheme's terms, each apart, with the diagnostics of `sphk rates`; the passes have just been run.
template <class S>
auto sums_of_rates(const State<S>& state, const Given& given) {
  using Terms = decltype(detail::apart_terms(typename S::RateTerms::List{}));
  Columns<S::dimension, typename Terms::Adds> out("diagnostics", state.n);
  add_pair_sums("diagnostics", state, Terms(given), out);
  return out;
}

template <class Terms, class C>
std::vector<TermShare> shares_of_terms() {
  std::vector<TermShare> shares;
  for_each_type(Terms{}, [&]<class T>() { detail::append_shares<T, C>(shares); });
  return shares;
}

/// What `sphk rates` writes of columns: the fields that are shown there, under their singular names.
std::vector<Field> shown_in_rates(const HostRows& rows, std::span<const FieldPlace> fields);

/// The shares of terms, as fields named after them: AccelerationViscosity, HeatingViscosity, ...
std::vector<Field> shares(const HostRows& rows, const std::vector<TermShare>& shares);

/// dA/dt of all terms, and alpha_loc of S12 eq 21 where the scheme has a gradient of div v.
template <class L>
void append_derived_rates(std::vector<Field>& fields, const Particles<L>& state, const HostColumns<L>& host,
                          const Given& given) {
  using Form = typename L::ThermalForm;
  fields.push_back(
      host.scalar("EntropyRate", "dA/dt of all terms", {.length = 2, .time = -3, .adiabatic = 1}, [&](int i) {
        const double rho = host.HostRows::at(i, state.state_density_row), gamma = host.gamma;
        const double work =
            -Form::pressure(host.template at<Thermal>(i), rho, gamma) / rho * host.template at<VelocityDivergence>(i);
        return Form::entropy_rate(host.template at<Heating>(i), work, rho, gamma);
      }));
  if constexpr (contains<GradVelocityDivergence, typename L::Fields>)
    fields.push_back(host.scalar("AlphaLoc", "alpha_loc of S12 eq 21", {}, [&](int i) {
      double grad2 = 0;
      for (int d = 0; d < L::dimension; ++d) grad2 += std::pow(host.template at<GradVelocityDivergence>(i, d), 2);
      return detail::local_alpha(host.template at<Support>(i), host.template at<VelocityDivergence>(i),
                                 std::sqrt(grad2), given[switch_noise] * host.template at<SoundSpeed>(i));
    }));
}

}  // namespace sphk
