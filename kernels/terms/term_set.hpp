// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/core/number.hpp"
#include "kernels/core/values.hpp"

namespace sphk {

/// The adiabatic index of the gas.
inline constexpr Number adiabatic_index{
    .key = "sph.gamma", .standard = 5.0 / 3, .meaning = "adiabatic index", .min = 1.0000001, .max = 100};

/// What decides, beside numbers, whether a term has anything to do.
struct GasTraits {
  bool equal_masses = false;
};

/// A term is a pure function of two particles' values, `term(sum, i, j, ij)`, which adds its share of the pair to i's
/// sums. It declares the fields it Reads and Adds, its Numbers and flops, is made from what a run gives to numbers, and
/// is branch-free in its number type. Where it can have nothing to add it says so: `idle(given, gas)`; where what it
/// adds to i and j cancels, weighted by their masses, it claims so: `using Antisymmetric = List<...>`. Where its
/// numbers can make it stiffer than what the Courant number is meant for it says how many times: `stiffness(given)`.
template <class... Terms>
struct TermSet : Terms... {
  using List = sphk::List<Terms...>;
  using Reads = Union<typename Terms::Reads...>;
  using Adds = Union<typename Terms::Adds...>;
  static constexpr int flops = (0 + ... + Terms::flops);

  explicit TermSet(const Given& given) : Terms(given)... {}

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    (static_cast<const Terms&>(*this)(sum, i, j, ij), ...);
  }
};

/// Base of terms without numbers of their own.
struct PlainTerm {
  PlainTerm() = default;
  explicit PlainTerm(const Given&) {}
};

}  // namespace sphk
