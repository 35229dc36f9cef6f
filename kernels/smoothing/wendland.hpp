// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/norm.hpp"
#include "kernels/smoothing/power.hpp"

namespace sphk {

/// Wendland's kernels of 2D and 3D (Wendland 1995; Dehnen & Aly 2012, table 1). q is cut at 1 before anything else, so
/// that the polynomial factor stays finite for a far-away q.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T cut_at_edge(T q) {
  return sphk::min(q, T(lane_t<T>(1)));
}

/// Wendland C2: (1-q)^4 (1+4q).
struct WendlandC2 {
  static constexpr const char* name = "wc2";
  static constexpr double spacings = 2.8794;
  static constexpr int flops = 10;

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION Shape<T> operator()(T q_any) const {
    using R = lane_t<T>;
    const T q = cut_at_edge(q_any), s = R(1) - q;
    const T s3 = power<3>(s);
    return {s3 * s * (R(1) + R(4) * q), R(-20) * q * s3};
  }
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T w(T q_any) const {
    using R = lane_t<T>;
    const T q = cut_at_edge(q_any);
    return power<4>(R(1) - q) * (R(1) + R(4) * q);
  }
  /// With s = 1-q the polynomial is 5 - 4 s.
  KOKKOS_INLINE_FUNCTION constexpr double norm(int dimension) const {
    return norm_from_moment(dimension, 5 * power_moment(4, dimension, 1) - 4 * power_moment(5, dimension, 1));
  }
};

/// Wendland C4: (1-q)^6 (1 + 6q + 35 q^2/3).
struct WendlandC4 {
  static constexpr const char* name = "wc4";
  static constexpr double spacings = 3.6277;
  static constexpr int flops = 16;

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION Shape<T> operator()(T q_any) const {
    using R = lane_t<T>;
    const T q = cut_at_edge(q_any), s = R(1) - q;
    const T s5 = power<5>(s);
    return {s5 * s * polynomial(q), R(-56.0 / 3) * q * s5 * (R(1) + R(5) * q)};
  }
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T w(T q_any) const {
    const T q = cut_at_edge(q_any);
    return power<6>(lane_t<T>(1) - q) * polynomial(q);
  }
  /// With s = 1-q the polynomial is (56 - 88 s + 35 s^2)/3.
  KOKKOS_INLINE_FUNCTION constexpr double norm(int dimension) const {
    return norm_from_moment(dimension, (56 * power_moment(6, dimension, 1) - 88 * power_moment(7, dimension, 1) +
                                        35 * power_moment(8, dimension, 1)) /
                                           3);
  }

 private:
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static T polynomial(T q) {
    using R = lane_t<T>;
    return R(1) + q * (R(6) + R(35.0 / 3) * q);
  }
};

/// Wendland C6: (1-q)^8 (1 + 8q + 25q^2 + 32q^3).
struct WendlandC6 {
  static constexpr const char* name = "wc6";
  static constexpr double spacings = 4.1525;
  static constexpr int flops = 20;

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION Shape<T> operator()(T q_any) const {
    using R = lane_t<T>;
    const T q = cut_at_edge(q_any), s = R(1) - q;
    const T s7 = power<7>(s);
    return {s7 * s * polynomial(q), R(-22) * q * s7 * (R(1) + q * (R(7) + R(16) * q))};
  }
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T w(T q_any) const {
    const T q = cut_at_edge(q_any);
    return power<8>(lane_t<T>(1) - q) * polynomial(q);
  }
  /// With s = 1-q the polynomial is 66 - 154 s + 121 s^2 - 32 s^3.
  KOKKOS_INLINE_FUNCTION constexpr double norm(int dimension) const {
    return norm_from_moment(dimension, 66 * power_moment(8, dimension, 1) - 154 * power_moment(9, dimension, 1) +
                                           121 * power_moment(10, dimension, 1) - 32 * power_moment(11, dimension, 1));
  }

 private:
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static T polynomial(T q) {
    using R = lane_t<T>;
    return R(1) + q * (R(8) + q * (R(25) + R(32) * q));
  }
};

}  // namespace sphk
