#pragma once

#include "src/engine/diagnostics.hpp"
#include "src/engine/error_fields.hpp"
#include "src/engine/scheme.hpp"
#include "src/engine/scheme_interface.hpp"

namespace sphk {

/// What scheme S tells the run that it serves.
template <class S>
SchemeFacts facts_of() {
  using L = typename S::Layout;
  SchemeFacts facts;
  facts.mixed = std::is_same_v<typename S::PairNumber, float>;
  facts.rows = Particles<L>::Columns::size;
  facts.bytes_per_particle = bytes_per_particle<L>;
  facts.flops_per_pair = flops_per_pair<S>();
  for_each_pass(typename S::Steps{}, [&]<class P>() {
    if (std::is_same_v<P, SmoothingLength>) facts.support_pass = static_cast<int>(facts.passes.size());
    facts.passes.push_back(P::name);
  });
  const auto show = [&]<class F>(F, const char* name, const char* description, UnitExponents units) {
    if constexpr (contains<F, typename L::Fields>)
      facts.shown.push_back({name, description, units, component_offset<L::dimension, F, typename L::Fields>});
  };
  show(VelocityDivergence{}, "VelocityDivergence", "div v", {0, 0, -1});
  show(Alpha{}, "Alpha", "Dissipation switch (S12 eq 21-23), before Balsara's factor", {});
  show(Balsara{}, "BalsaraFactors", "Balsara factor", {});
  facts.state_density_row = component_offset<L::dimension, Density, typename L::Fields>;
  if constexpr (FreeFunctionsOf<S>::general_density) {
    facts.state_density_row = component_offset<L::dimension, GeneralDensity, typename L::Fields>;
    show(GeneralDensity{}, "GeneralDensities", "Density of the equations of motion (R10 eq 19)", {-L::dimension, 1, 0});
  }
  if constexpr (contains<Alpha, typename L::Fields>)
    facts.alpha_row = component_offset<L::dimension, Alpha, typename L::Fields>;
  return facts;
}

/// The passes of scheme S.
template <class S>
class PassesOf final : public SchemePasses<BaseLayout<typename S::Layout>> {
 public:
  using L = typename S::Layout;

  explicit PassesOf(const typename S::Kernel& kernel)
      : SchemePasses<BaseLayout<L>>(facts_of<S>()), smoothing_(kernel) {}

  void run(int pass, RunOf<L>& run) const override {
    int k = 0;
    for_each_pass(typename S::Steps{}, [&]<class P>() {
      if (k++ == pass) run_pass<P, S>(run, smoothing_);
    });
  }
  std::vector<Field> rates(const Particles<BaseLayout<L>>& particles, bool split) const override {
    if constexpr (std::is_same_v<typename S::PairNumber, double>) {
      const State<S> state{particles.template as<L>(), smoothing_};
      std::vector<Field> fields =
          rate_fields<typename S::RateTerms::List>(state.template as<L>(), sums_of_rates(state), split);
      for (Field& field : errors(particles)) fields.push_back(std::move(field));
      return fields;
    } else {
      throw std::logic_error("rates are computed in double: make the simulation with precision \"double\"");
    }
  }

  std::vector<Field> errors(const Particles<BaseLayout<L>>& particles) const override {
    return error_fields<S>(particles.template as<L>(), smoothing_);
  }

 private:
  SmoothingOf<S> smoothing_;
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
