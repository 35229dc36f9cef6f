// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <tuple>

#include "src/engine/diagnostics.hpp"
#include "src/engine/passes_of.hpp"

namespace sphk {

namespace detail {

template <class P>
constexpr PassFacts pass_facts() {
  if constexpr (requires(const Given& given) { P::wanted(given); })
    return {P::name, &P::wanted};
  else
    return {P::name, +[](const Given&) { return true; }};
}

/// Row of the density that the equations of motion take: that of the last pass that makes pressures of one.
template <class L, class P>
constexpr int state_density_row(int row) {
  if constexpr (requires { typename P::StateDensity; })
    return component_offset<L::dimension, typename P::StateDensity, typename L::Fields>;
  else
    return row;
}

/// Does pass P compute the field in this row?
template <class R, class L, class P>
constexpr bool writes_row(int row) {
  bool found = false;
  for_each_type(typename PassIn<P, R>::Writes{}, [&]<class F>() {
    if constexpr (contains<F, typename L::Fields>)
      found = found || component_offset<L::dimension, F, typename L::Fields> == row;
  });
  return found;
}

}  // namespace detail

template <class R, class L>
CompiledFacts facts_of_recipe() {
  CompiledFacts facts;
  facts.fields = field_places<L::dimension, typename L::Fields>;
  facts.rows = Particles<L>::Columns::size;
  facts.bytes_per_particle = bytes_per_particle<L>;
  facts.stiffness = &stiffness<R>;
  for_each_type(typename R::StepPasses{}, [&]<class P>() {
    if (std::is_same_v<P, SmoothingLength>) facts.support_pass = static_cast<int>(facts.passes.size());
    facts.passes.push_back(detail::pass_facts<P>());
    facts.state_density_row = detail::state_density_row<L, P>(facts.state_density_row);
  });
  int pass = 0;
  for_each_type(typename R::StepPasses{}, [&]<class P>() {
    if (detail::writes_row<R, L, P>(facts.state_density_row)) facts.density_pass = pass;
    ++pass;
  });
  if constexpr (contains<Alpha, typename L::Fields>)
    facts.alpha_row = component_offset<L::dimension, Alpha, typename L::Fields>;
  return facts;
}

template <class R, class L>
void run_particle_pass(int pass, RunOf<L>& run) {
  int k = 0;
  for_each_type(typename R::StepPasses{}, [&]<class P>() {
    const bool here = k++ == pass;
    if constexpr (!is_over_pairs<P>) {
      if (here) P::template run<L>(run);
    }
  });
}

template <class R, class L, class K>
std::vector<Field> rates_of_recipe(const RunOf<L>& run, std::span<const FieldPlace> places,
                                   const Smoothing<K, L::dimension>& smoothing, bool split) {
  const State<Scheme<R, L::dimension, K, double>> state{run.state.template as<L>(), smoothing};
  const HostColumns<L> host(state);
  std::vector<Field> fields = shown_in_rates(host, places);
  append_derived_rates<L>(fields, state, host, run.given);
  const auto sums = sums_of_rates(state, run.given);
  using Sums = std::remove_const_t<decltype(sums)>;
  const HostRows rows(host, sums.data, sums.stride);
  for (Field& field : shown_in_rates(rows, field_places<L::dimension, typename Sums::Fields>))
    if (std::ranges::find(fields, field.name, &Field::name) == fields.end()) fields.push_back(std::move(field));
  if (split)
    for (Field& field : shares(rows, shares_of_terms<typename R::RateTerms::List, Sums>()))
      fields.push_back(std::move(field));
  return fields;
}

template <class L>
void predict_sleepers(const RunOf<L>& run) {
  predict<L>(run, {});
}

namespace detail {

template <class R, int D>
constexpr auto recipe_parts() {
  using L = typename Scheme<R, D, CubicSpline, double>::Layout;  // that of every kernel and number type
  const auto always = std::tuple{&facts_of_recipe<R, L>, &run_particle_pass<R, L>, &predict_sleepers<L>};
  if constexpr (std::is_same_v<typename R::Kernels::template in<D>, List<>>)
    return std::tuple{};
  else if constexpr (is_complete<R>)
    return std::tuple_cat(always, std::tuple{&rates_of_recipe<R, L, AnyKernel>});
  else
    return always;
}

}  // namespace detail

/// Addresses of all these parts of some recipes in D dimensions, which makes the compiler write them.
template <int D, class... R>
constexpr auto recipe_parts(List<R...>) {
  return std::tuple_cat(detail::recipe_parts<R, D>()...);
}

}  // namespace sphk
