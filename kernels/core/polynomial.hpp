// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "kernels/core/vec.hpp"

namespace sphk {

/// Monomials of D variables, by degree: 1; x, y, z; x2, y2, z2, xy, xz, yz (S12 eq 28); then all of degree 3 and 4. The
/// first `basis` of them are those of a second-order polynomial; the `count` are what products of two of these are.
template <int D>
struct Monomials {
  static constexpr int linear = 1 + D;                 ///< 2, 3, 4
  static constexpr int basis = (D + 1) * (D + 2) / 2;  ///< 3, 6, 10
  static constexpr int count = D == 1 ? 5 : D == 2 ? 15 : 35;

  struct Powers {
    int of[3];
    constexpr int degree() const { return of[0] + of[1] + of[2]; }
    constexpr bool operator==(const Powers&) const = default;
  };

  /// Host only: device code takes single values, as template arguments.
  struct Table {
    Powers of[count];
    constexpr Table() : of{} {
      for (int k = 0; k < basis; ++k) of[k] = basis_powers(k);
      int k = basis;
      for (int degree = 3; degree <= 4; ++degree)
        for (int a = degree; a >= 0; --a)
          for (int b = degree - a; b >= 0; --b)
            if (const int c = degree - a - b; (D == 3 || c == 0) && (D > 1 || b == 0)) of[k++] = {{a, b, c}};
    }
  };
  static constexpr Powers powers(int k) { return Table().of[k]; }
  static constexpr int index(const Powers& wanted, const Table& table = {}) {
    for (int k = 0; k < count; ++k)
      if (table.of[k] == wanted) return k;
    return -1;
  }
  /// Which monomial the product of two of the basis is.
  static constexpr int product(int a, int b, const Table& table = {}) {
    const Powers p = table.of[a], q = table.of[b];
    return index({{p.of[0] + q.of[0], p.of[1] + q.of[1], p.of[2] + q.of[2]}}, table);
  }
  /// Two of the basis whose product is monomial k: `other` of the second degree where k has more than two.
  struct Factors {
    int one, other;
  };
  static constexpr Factors factors(int k) {
    const Table table;
    for (int b = basis - 1; b >= 0; --b)
      for (int a = 0; a < basis; ++a)
        if (product(a, b, table) == k) return {a, b};
    return {-1, -1};
  }
  /// The basis function x_a x_b, or x_a where b is absent.
  static constexpr int second(int a, int b) {
    Powers p{{0, 0, 0}};
    ++p.of[a], ++p.of[b];
    return index(p);
  }

 private:
  static constexpr Powers basis_powers(int k) {
    Powers p{{0, 0, 0}};
    if (k == 0) return p;
    if (k <= D) return p.of[k - 1] = 1, p;
    if (k <= 2 * D) return p.of[k - D - 1] = 2, p;
    const int pair = k - 2 * D - 1;  // xy, xz, yz
    p.of[pair < 2 ? 0 : 1] = 1;
    p.of[pair == 0 ? 1 : 2] = 1;
    return p;
  }
};

/// Monomial k of the basis at x.
template <int D, int k, class P>
KOKKOS_FORCEINLINE_FUNCTION P basis_value(const Vec<P, D>& x) {
  constexpr auto p = Monomials<D>::powers(k);
  static_assert(k < Monomials<D>::basis);
  P value = P(lane_t<P>(1));
  if constexpr (D > 0 && p.of[0] > 0) value = p.of[0] == 2 ? x[0] * x[0] : x[0];
  if constexpr (D > 1 && p.of[1] > 0) {
    const P y = p.of[1] == 2 ? x[1] * x[1] : x[1];
    value = p.of[0] > 0 ? value * y : y;
  }
  if constexpr (D > 2 && p.of[2] > 0) {
    const P z = p.of[2] == 2 ? x[2] * x[2] : x[2];
    value = p.of[0] + p.of[1] > 0 ? value * z : z;
  }
  return value;
}

/// Calls f.template operator()<k>() for k = 0 ... n - 1.
template <int n, class F>
KOKKOS_FORCEINLINE_FUNCTION void for_each_index(F&& f) {
  [&]<int... k>(std::integer_sequence<int, k...>) {
    (f.template operator()<k>(), ...);
  }
  (std::make_integer_sequence<int, n>{});
}

/// Weighted least squares for second-order polynomials in D variables (S12 eq 27, App. D), a fit a lane: M a = q with
/// the moments M_ab = sum w f_a f_b and q_b = sum w f_b q, for `sides` fields q that share M. Factors M = L D L^T; the
/// leading block of it is the linear fit's.
template <class P, int D, int sides>
struct PolynomialFit {
  using M = Monomials<D>;
  static constexpr int size = M::basis;
  using T = lane_t<P>;

  P L[size][size];  ///< below the diagonal
  P d_inv[size];
  P a[sides][size];           ///< coefficients; in: right-hand sides
  P quality, linear_quality;  ///< the smallest D_k / M_kk: 1 for independent columns, 0 for degenerate neighbours

  /// Factors the matrix of the moments. A pivot that is not positive is taken as infinite.
  KOKKOS_INLINE_FUNCTION void factor(const P* moments) {
    quality = P(T(1));
    for_each_index<size>([&]<int k>() {
      P column[size];
      for_each_index<size>([&]<int r>() {
        if constexpr (r >= k) {
          constexpr int moment = M::product(r, k);
          column[r] = moments[moment];
          for_each_index<k>([&]<int s>() { column[r] = column[r] - L[r][s] * L[k][s] * d[s]; });
        }
      });
      constexpr int diagonal = M::product(k, k);
      const P scale = moments[diagonal];
      const auto positive = P(T(0)) < column[k];
      d[k] = column[k];
      d_inv[k] = select(positive, P(T(1)) / select(positive, column[k], P(T(1))), P(T(0)));
      const P ratio = select(P(T(0)) < scale, column[k] / select(P(T(0)) < scale, scale, P(T(1))), P(T(0)));
      quality = sphk::min(quality, ratio);
      if constexpr (k == M::linear - 1) linear_quality = quality;
      for_each_index<size>([&]<int r>() {
        if constexpr (r > k) L[r][k] = column[r] * d_inv[k];
      });
    });
  }
  /// Replaces right-hand sides by the coefficients of the second-order fits, or of linear ones (the others zero) where
  /// `linear` says so.
  KOKKOS_INLINE_FUNCTION void solve(const auto& linear) {
    for (int side = 0; side < sides; ++side) {
      P* y = a[side];
      for_each_index<size>([&]<int r>() { for_each_index<r>([&]<int s>() { y[r] = y[r] - L[r][s] * y[s]; }); });
      for_each_index<size>([&]<int r>() { y[r] = y[r] * d_inv[r]; });
      for_each_index<size>([&]<int r>() {
        if constexpr (r >= M::linear) y[r] = select(linear, P(T(0)), y[r]);
      });
      for_each_index<size>([&]<int back>() {
        constexpr int r = size - 1 - back;
        for_each_index<back>([&]<int s>() { y[r] = y[r] - L[size - 1 - s][r] * y[size - 1 - s]; });
      });
    }
  }

 private:
  P d[size];
};

}  // namespace sphk
