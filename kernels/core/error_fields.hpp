#pragma once

#include "kernels/core/fields.hpp"

namespace sphk {

// What tells how well particles sample their kernels.

/// Entropy function A = P / rho^gamma.
struct Entropy {
  static constexpr const char* name = "Entropies";
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
  static constexpr const char* name = "E0";
  template <class T, int D>
  struct Value {
    Vec<T, D> E0;
  };
};

/// R_i, the error matrix of the continuity equation, 1 where it is exact to first order (R10 eq 29): xx, yy, zz, xy,
/// xz, yz, those that there are.
struct ErrorR {
  static constexpr const char* name = "R";
  template <class T, int D>
  struct Value {
    Vec<T, symmetric_size<D>> R;
  };
};

/// V_i, that of the momentum equation's pressure gradient, in the same order.
struct ErrorV {
  static constexpr const char* name = "V";
  template <class T, int D>
  struct Value {
    Vec<T, symmetric_size<D>> V;
  };
};

/// max |ln(A_i/A_j)| over neighbours with r < h_i: large where fluids meet.
struct EntropyContrast {
  static constexpr const char* name = "EntropyContrast";
  static constexpr bool is_maximum = true;
  template <class T, int D>
  struct Value {
    T contrast;
  };
};

/// 1/r of the nearest neighbour apart from coincident ones; 0 where there is none within h_i.
struct InverseNearest {
  static constexpr const char* name = "InverseNearest";
  static constexpr bool is_maximum = true;
  template <class T, int D>
  struct Value {
    T nearest_inv;
  };
};

}  // namespace sphk
