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

// What hangs neither on the smoothing kernel nor on the pair arithmetic is compiled once for all of a recipe's: a
// compiler's time is long. Defined in recipe_parts.hpp, which code with schemes of its own includes as well.

/// What a recipe with layout L tells the run that it serves, but for what hangs on these.
template <class R, class L>
CompiledFacts facts_of_recipe();
/// Runs a pass that needs neither.
template <class R, class L>
void run_particle_pass(int pass, RunOf<L>& run);
/// Predicts all of sleeping particles.
template <class L>
void predict_sleepers(const RunOf<L>& run);
/// One right-hand side of recipe R, which the passes have just computed, with kernel K, in double.
template <class R, class L, class K>
std::vector<Field> rates_of_recipe(const RunOf<L>& run, std::span<const FieldPlace> places,
                                   const Smoothing<K, L::dimension>& smoothing, bool split);

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

  void predict(const RunOf<L>& run) const override { predict_sleepers<L>(run); }

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
