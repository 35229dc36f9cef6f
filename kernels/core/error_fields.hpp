// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/core/fields.hpp"

namespace sphk {

// What tells how well particles sample their kernels.

/// Entropy function A = P / rho^gamma.
struct Entropy {
  static constexpr FieldFacts facts{.name = "Entropies",
                                    .description = "Entropy function A = P / rho^gamma",
                                    .unit = {.length = 2, .time = -2, .adiabatic = 1}};
  template <class T, int D>
  struct Value {
    T A;
  };
};

/// Components of a symmetric matrix.
template <int D>
inline constexpr int symmetric_size = D*(D + 1) / 2;

/// E0_i, the zeroth-order error of the momentum equation: dv_i/dt = - P E0_i / (h_i rho_i) where P is even (R10 eq 28).
struct ErrorE0 {
  static constexpr FieldFacts facts{.name = "E0",
                                    .description = "Zeroth-order error of the force (R10 eq 28)",
                                    .rank = Rank::vector,
                                    .shown = Shown::in_rates};
  template <class T, int D>
  struct Value {
    Vec<T, D> E0;
  };
};

/// R_i, the error matrix of the continuity equation, 1 where it is exact to first order (R10 eq 29): xx, yy, zz, xy,
/// xz, yz, those that there are.
struct ErrorR {
  static constexpr FieldFacts facts{.name = "R",
                                    .description = "Error matrix of the continuity equation (R10 eq 29)",
                                    .rank = Rank::matrix,
                                    .shown = Shown::in_rates};
  template <class T, int D>
  struct Value {
    Vec<T, symmetric_size<D>> R;
  };
};

/// V_i, that of the momentum equation's pressure gradient, in the same order.
struct ErrorV {
  static constexpr FieldFacts facts{.name = "V",
                                    .description = "Error matrix of the momentum equation (R10 eq 29)",
                                    .rank = Rank::matrix,
                                    .shown = Shown::in_rates};
  template <class T, int D>
  struct Value {
    Vec<T, symmetric_size<D>> V;
  };
};

/// (d eta/dt)/eta of R10's free function eta.
struct EtaRate {
  static constexpr FieldFacts facts{.name = "EtaRates", .description = "d ln(eta)/dt", .unit = {.time = -1}};
  template <class T, int D>
  struct Value {
    T eta_rate;
  };
};

/// epsilon_i, what the density's own rate of change has beside the continuity equation where eta changes (R10 eq 21).
struct ErrorEpsilon {
  static constexpr FieldFacts facts{.name = "Epsilon",
                                    .description = "Residual of the continuity equation (R10 eq 21)",
                                    .unit = {.mass = 1, .time = -1, .volume = -1},
                                    .shown = Shown::in_rates};
  template <class T, int D>
  struct Value {
    T epsilon;
  };
};

/// max |ln(A_i/A_j)| over neighbours with r < h_i: large where fluids meet.
struct EntropyContrast {
  static constexpr FieldFacts facts{.name = "EntropyContrast",
                                    .description = "Largest |ln(A_i/A_j)| over neighbours with r < h",
                                    .shown = Shown::in_rates,
                                    .maximum = true};
  template <class T, int D>
  struct Value {
    T contrast;
  };
};

/// 1/r of the nearest neighbour apart from coincident ones; 0 where there is none within h_i.
struct InverseNearest {
  static constexpr FieldFacts facts{.name = "InverseNearest",
                                    .description = "1/r of the nearest neighbour; 0: none within h",
                                    .unit = {.length = -1},
                                    .maximum = true};
  template <class T, int D>
  struct Value {
    T nearest_inv;
  };
};

}  // namespace sphk
