#pragma once

#include "kernels/smoothing/pair.hpp"
#include "kernels/terms/term_set.hpp"

namespace sphk {

/// rho_i = sum_j m_j W(r_ij, h_i) (S12 eq 6) and its derivative in h.
struct DensitySum : PlainTerm {
  using PlainTerm::PlainTerm;
  using Reads = List<Position, Mass>;
  using Adds = List<Density, DensitySlope>;
  static constexpr int flops = 4;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto&, const auto& j, const auto& ij) const {
    sum.rho = sum.rho + j.m * ij.W;
    sum.drho_dh = sum.drho_dh + j.m * ij.dW_dh;
  }
};

/// rho_i div v = - sum_j m_j v_ij . grad W(h_i): the standard SPH estimate; the division by rho_i comes after the sum.
struct VelocityDivergenceSum : PlainTerm {
  using PlainTerm::PlainTerm;
  using Reads = List<Position, Mass, Velocity>;
  using Adds = List<VelocityDivergence>;
  static constexpr int flops = 10;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    sum.div_v = sum.div_v - j.m * dot(i.v - j.v, ij.grad_W);
  }
};

/// rho_i curl v = sum_j m_j v_ij x grad W(h_i).
struct VelocityCurlSum : PlainTerm {
  using PlainTerm::PlainTerm;
  using Reads = List<Position, Mass, Velocity>;
  using Adds = List<VelocityCurl>;
  static constexpr int flops = 18;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto& i, const auto& j, const auto& ij) const {
    sum.curl_v += j.m * cross(i.v - j.v, ij.grad_W);
  }
};

/// Neighbours with r < h_i, self included.
struct NeighbourCountSum : PlainTerm {
  using PlainTerm::PlainTerm;
  using Reads = List<Position>;
  using Adds = List<NeighbourCount>;
  static constexpr int flops = 2;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(auto& sum, const auto&, const auto&, const auto& ij) const {
    using P = std::remove_cvref_t<decltype(ij.q)>;
    using T = lane_t<P>;
    sum.count = sum.count + select(ij.q < P(T(1)), P(T(1)), P(T(0)));
  }
};

}  // namespace sphk
