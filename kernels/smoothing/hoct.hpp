// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/smoothing/norm.hpp"
#include "kernels/smoothing/power.hpp"

namespace sphk {

namespace detail {
/// Coefficients of HOCTn, from R10 eq 47-51 with the inner edges beta = 1/2 and gamma = 3/4.
template <int n>
struct HoctCoefficients {
  double beta = 0.5, gamma = 0.75;
  double A = 0, B = 0;
  double kappa = 0;     ///< edge of the linear core, where the second derivative vanishes
  double P = 0, Q = 0;  ///< the core's slope and its value at q = 0

  constexpr HoctCoefficients() {
    double gamma_n3 = 1;
    for (int k = 3; k < n; ++k) gamma_n3 *= gamma;
    A = (1 - beta * beta) / (gamma_n3 * (gamma * gamma - beta * beta));
    B = -(1 + A * power<n - 1>(gamma)) / power<n - 1>(beta);
    kappa = inflection();
    P = -n * sum<n - 1>(kappa);
    Q = sum<n>(kappa) - P * kappa;
  }
  template <int m>
  constexpr double sum(double q) const {
    return power<m>(1 - q) + A * power<m>(gamma - q) + B * power<m>(beta - q);
  }
  /// Root of the second derivative in (0, beta), by bisection down to adjacent doubles.
  constexpr double inflection() const {
    double low = 0, high = beta;
    for (double middle = beta / 2; low < middle && middle < high; middle = (low + high) / 2)
      (sum<n - 2>(middle) < 0 ? low : high) = middle;
    return low;
  }
};
}  // namespace detail

/// High-order core triangle HOCTn, R10 eq 46-51: (1-q)^n + A (gamma-q)_+^n + B (beta-q)_+^n with the linear core
/// P q + Q below q = kappa. (S12 eq 17 lost A and B.)
template <int n>
struct Hoct {
  static_assert(n >= 3 && n <= 9);
  static constexpr char name[] = {'h', 'o', 'c', 't', '0' + n, '\0'};
  static constexpr double spacings = 4.7256;
  static constexpr int flops = truncated_powers_flops(n) + 5;
  static constexpr detail::HoctCoefficients<n> coefficients{};
  static constexpr double A = coefficients.A, B = coefficients.B, P = coefficients.P, Q = coefficients.Q;
  static constexpr double kappa = coefficients.kappa, beta = coefficients.beta, gamma = coefficients.gamma;

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION Shape<T> operator()(T q) const {
    using R = lane_t<T>;
    const Shape<T> outside = truncated_powers<n>(sphk::max(q, T(R(kappa))), {gamma, A, beta, B});
    return {outside.w + core(q), outside.dw};
  }
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T w(T q) const {
    return truncated_powers_w<n>(sphk::max(q, T(lane_t<T>(kappa))), {gamma, A, beta, B}) + core(q);
  }
  KOKKOS_INLINE_FUNCTION constexpr double norm(int dimension) const {
    const double outside = power_moment(n, dimension, 1, kappa) + A * power_moment(n, dimension, gamma, kappa) +
                           B * power_moment(n, dimension, beta, kappa);
    return norm_from_moment(dimension, outside + core_moment(dimension, Q, P, kappa));
  }

 private:
  /// What the linear core adds to the value at its edge.
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static T core(T q) {
    using R = lane_t<T>;
    return R(P) * sphk::min(q - R(kappa), T(R(0)));
  }
};

}  // namespace sphk
