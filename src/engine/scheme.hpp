#pragma once

#include "kernels/passes/kick_drift.hpp"
#include "kernels/passes/state_equation.hpp"
#include "kernels/passes/step_passes.hpp"

namespace sphk {

namespace detail {
template <class P>
struct KeptBy {
  using type = List<>;
};
template <class P>
requires requires {
  typename P::Keeps;
}
struct KeptBy<P> {
  using type = typename P::Keeps;
};
}  // namespace detail

/// Passes in the order of a step. A pass writes its fields where a term reads them; what it Keeps is there anyway.
template <class... P>
struct Passes {
  using Writes = Union<typename P::Writes...>;
  using Keeps = Union<typename detail::KeptBy<P>::type...>;
};

/// Calls f.template operator()<P>() for every pass P.
template <class... P, class F>
void for_each_pass(Passes<P...>, F&& f) {
  (f.template operator()<P>(), ...);
}

/// What schemes have in common that differ in smoothing kernel and pair arithmetic alone.
template <class L, class StepPasses, class TermList>
struct Model {
  using Layout = L;
  using Steps = StepPasses;
  using Terms = TermList;
};

/// A scheme: dimension, smoothing kernel, pair arithmetic (float or double), thermal variable, the sums of the density
/// loop beside n and rho, the terms of the rates loop and the passes of a step. What is not listed is not compiled, not
/// allocated, not run.
template <int D, class K, class T, class Form, class DensitySums, class Terms, class StepPasses>
struct Scheme {
  static constexpr int dimension = D;
  using Kernel = K;
  using PairNumber = T;
  using ThermalForm = Form;
  using DensityTerms = DensitySums;
  using RateTerms = Terms;
  using Steps = StepPasses;

  using Known = Union<BaseFields, typename DensityTerms::Adds, typename StepPasses::Writes, typename StepPasses::Keeps>;
  static_assert(is_subset<typename RateTerms::Reads, Known>,
                "a term reads a field that no pass of this scheme computes: add the pass or the density sum that does");

  using All = Union<BaseFields, typename DensityTerms::Reads, typename DensityTerms::Adds, typename RateTerms::Reads,
                    typename RateTerms::Adds, typename StepPasses::Keeps>;
  template <class F>
  using IsListed = std::bool_constant<contains<F, All>>;
  using CoreList = Union<BaseFields, Filter<CoreFields, IsListed>>;
  using Core = CoreScheme<sphk::Layout<D, CoreList, void>, K, T, DensitySums>;
  using Layout = sphk::Layout<D, Union<CoreList, All>, Form>;
  using Fields = typename Layout::Fields;
  using Model = sphk::Model<Layout, StepPasses, typename Terms::List>;
};

}  // namespace sphk
