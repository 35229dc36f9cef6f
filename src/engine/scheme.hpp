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

  using Base = List<Position, Velocity, HalfStepVelocity, Mass, Thermal, HalfStepThermal, ThermalRate, Support,
                    InverseSupport, NumberDensity, NumberDensitySlope, Density>;
  using Known = Union<Base, typename DensityTerms::Adds, typename StepPasses::Writes, typename StepPasses::Keeps>;
  static_assert(is_subset<typename RateTerms::Reads, Known>,
                "a term reads a field that no pass of this scheme computes: add the pass or the density sum that does");

  using Layout = sphk::Layout<D,
                              Union<Base, typename DensityTerms::Reads, typename DensityTerms::Adds,
                                    typename RateTerms::Reads, typename RateTerms::Adds, typename StepPasses::Keeps>,
                              Form>;
  using Fields = typename Layout::Fields;
};

}  // namespace sphk
