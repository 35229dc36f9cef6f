// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "kernels/smoothing/any.hpp"
#include "src/engine/diagnostics.hpp"
#include "src/engine/error_fields.hpp"
#include "src/engine/error_loops.hpp"
#include "src/engine/scheme.hpp"
#include "src/engine/scheme_interface.hpp"

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

/// What a recipe with layout L tells the run that it serves, but for what hangs on kernel and pair arithmetic. Apart
/// from the schemes that differ in these two alone, as is what follows: a compiler's time is long.
template <class R, class L>
[[gnu::noinline]] CompiledFacts facts_of_recipe() {
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

/// Runs a pass that needs neither.
template <class R, class L>
[[gnu::noinline]] void run_particle_pass(int pass, RunOf<L>& run) {
  int k = 0;
  for_each_type(typename R::StepPasses{}, [&]<class P>() {
    const bool here = k++ == pass;
    if constexpr (!is_over_pairs<P>) {
      if (here) P::template run<L>(run);
    }
  });
}

/// One right-hand side of recipe R, which the passes have just computed, with kernel K, in double.
template <class R, class L, class K>
[[gnu::noinline]] std::vector<Field> rates_of_recipe(const RunOf<L>& run, std::span<const FieldPlace> places,
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

/// What scheme S tells the run that it serves.
template <class S>
CompiledFacts facts_of() {
  CompiledFacts facts = facts_of_recipe<typename S::Recipe, typename S::Layout>();
  facts.mixed = std::is_same_v<typename S::PairNumber, float>;
  facts.flops_per_pair = flops_per_pair<S>();
  return facts;
}

/// The passes of scheme S.
template <class S>
class PassesOf final : public SchemePasses<BaseLayout<typename S::Layout>> {
 public:
  using L = typename S::Layout;
  using R = typename S::Recipe;

  explicit PassesOf(const typename S::Kernel& kernel)
      : SchemePasses<BaseLayout<L>>(facts_of<S>()), smoothing_(kernel), seldom_(seldom_used(kernel)) {}

  void run(int pass, RunOf<L>& run) const override {
    int k = 0;
    bool over_pairs = false;
    for_each_type(typename S::StepPasses{}, [&]<class P>() {
      const bool here = k++ == pass;
      if constexpr (is_over_pairs<P>) {
        if (here) P::template run<S>(run, smoothing_), over_pairs = true;
      }
    });
    if (!over_pairs) run_particle_pass<R, L>(pass, run);
  }

  void predict(const RunOf<L>& run) const override { sphk::predict<L>(run, {}); }

  std::vector<Field> rates(const RunOf<L>& run, bool split) const override {
    if constexpr (is_complete<R>) {
      std::vector<Field> fields = rates_of_recipe<R, L>(run, this->facts.fields, seldom_, split);
      for (Field& field : errors(run.state)) fields.push_back(std::move(field));
      return fields;
    } else {
      throw std::logic_error("rates are told of all terms: make the simulation with all_terms");
    }
  }

  std::vector<Field> errors(const Particles<BaseLayout<L>>& particles) const override {
    return error_fields(error_particles<R>(particles.template as<L>()), seldom_);
  }

 private:
  SmoothingOf<S> smoothing_;
  Smoothing<decltype(seldom_used(std::declval<typename S::Kernel>())), S::dimension> seldom_;
};

/// A loaded run for the passes of scheme S, one by one.
template <class S>
RunOf<typename S::Layout> load_run(const ParticleSet& particles, const SimulationSettings& settings,
                                   const SmoothingOf<S>& smoothing) {
  using Base = BaseLayout<typename S::Layout>;
  return load_run<Base>(particles, settings, facts_of<S>(),
                        [&](Run<Base>& run) { SmoothingLength::run<S>(run, smoothing); });
}

}  // namespace sphk
