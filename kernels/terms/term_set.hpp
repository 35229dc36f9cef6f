#pragma once

#include "kernels/core/values.hpp"

namespace sphk {

/// Numbers that terms and passes read, in code units; one set for a run.
struct Parameters {
  double neighbours = 48;      ///< N_n of S12 eq 11
  double gamma = 5.0 / 3;      ///< adiabatic index
  double courant = 0.4;        ///< C of S12 eq 43
  double alpha = 1, beta = 2;  ///< viscosity
  double h_max = 0;            ///< cap of the support radius
};

/// A term is a pure function of two particles' values, `term(sum, i, j, ij)`, which adds its share of the pair to i's
/// sums. It declares the fields it Reads and Adds and its flops, is made from Parameters, and is branch-free in its
/// number type.
template <class... Terms>
struct TermSet : Terms... {
  using List = sphk::List<Terms...>;
  using Reads = Union<typename Terms::Reads...>;
  using Adds = Union<typename Terms::Adds...>;
  static constexpr int flops = (0 + ... + Terms::flops);

  explicit TermSet(const Parameters& parameters) : Terms(parameters)... {}

  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    (static_cast<const Terms&>(*this)(sum, i, j, ij), ...);
  }
};

/// Base of terms without numbers of their own.
struct PlainTerm {
  PlainTerm() = default;
  explicit PlainTerm(const Parameters&) {}
};

}  // namespace sphk
