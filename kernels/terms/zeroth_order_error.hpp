#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// E0_i = 2 sum_j (m_j/rho_j) h_i grad Wbar (S12 eq 13).
struct ZerothOrderError : PlainTerm {
  static constexpr const char* name = "zeroth-order error E0 (S12 eq 13)";
  using PlainTerm::PlainTerm;
  using Reads = List<Position, InverseSupport, Support, Mass, Density>;
  using Adds = List<ErrorE0>;
  static constexpr int flops = 9;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(i.m)>;
    sum.E0 += (P(lane_t<P>(2)) * j.m * i.h / j.rho) * ij.grad_W;
  }
};

}  // namespace sphk
