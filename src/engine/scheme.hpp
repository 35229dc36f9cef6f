// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/kick_drift.hpp"
#include "kernels/passes/recipe.hpp"
#include "kernels/passes/state_equation.hpp"
#include "kernels/passes/step_passes.hpp"

namespace sphk {

/// A recipe in D dimensions, with smoothing kernel K and pair arithmetic in T (float or double): what is compiled.
template <class R, int D, class K, class T>
struct Scheme {
  static constexpr int dimension = D;
  using Recipe = R;
  using Kernel = K;
  using PairNumber = T;
  using ThermalForm = typename R::ThermalForm;
  using DensityTerms = typename R::DensityTerms;
  using RateTerms = typename R::RateTerms;
  using StepPasses = typename R::StepPasses;
  static_assert(in_order<R>);

  template <class F>
  using IsThere = std::bool_constant<contains<F, Union<BaseFields, WrittenIn<R>>>>;
  using All =
      Union<BaseFields, typename DensityTerms::Adds, typename RateTerms::Adds, KeptIn<R>, Filter<ReadIn<R>, IsThere>>;
  template <class F>
  using IsListed = std::bool_constant<contains<F, All>>;
  using CoreList = Union<BaseFields, Filter<CoreFields, IsListed>>;
  using Core = CoreScheme<sphk::Layout<D, CoreList, void>, K, T, DensityTerms>;
  using Layout = sphk::Layout<D, Union<CoreList, All>, ThermalForm>;
  using Fields = typename Layout::Fields;
};

}  // namespace sphk
