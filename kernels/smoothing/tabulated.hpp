// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <string_view>

#include "kernels/smoothing/shape.hpp"

namespace sphk {

/// Any smoothing kernel as a table: w and dw, each by a cubic of its own in every interval of q, so that one compiled
/// loop serves every kernel. The error stays below 1e-7 of the largest |w| or |dw|, and below 1e-10 outside intervals
/// that hold a kink of a derivative, such as the edge of a linear core. A gather costs 15 times HOCT4's closed form.
class Tabulated {
 public:
  static constexpr int intervals = 8192;
  static constexpr int flops = 15;

  /// Tabulates a kernel of kernels/smoothing, under its name unless another is given (at most 15 characters are kept).
  /// Host only; copies share the table.
  template <class Kernel>
  explicit Tabulated(const Kernel& kernel, std::string_view name = Kernel::name)
      : norms_{kernel.norm(1), kernel.norm(2), kernel.norm(3)},
        force_norms_{sphk::norm_of_forces(kernel, 1), sphk::norm_of_forces(kernel, 2),
                     sphk::norm_of_forces(kernel, 3)} {
    name.copy(name_, sizeof(name_) - 1);
    Table table("smoothing kernel table", intervals + 1);
    const auto rows = Kokkos::create_mirror_view(Kokkos::HostSpace{}, table);
    for (int k = 0; k < intervals; ++k) {
      Shape<double> y[4];
      for (int p = 0; p < 4; ++p) y[p] = kernel((k + p / 3.0) / intervals);
      fit(&rows(k, 0), y[0].w, y[1].w, y[2].w, y[3].w);
      fit(&rows(k, 4), y[0].dw, y[1].dw, y[2].dw, y[3].dw);
    }
    Kokkos::deep_copy(Kokkos::DefaultExecutionSpace{}, table, rows);
    Kokkos::fence("smoothing kernel table filled");
    table_ = table;
  }

  static constexpr bool lane_by_lane = true;  ///< packs are no faster than numbers one by one

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION Shape<T> operator()(T q) const {
    const Row<T> row = gather(q);
    return {row.value(0), row.value(4)};
  }
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T w(T q) const {
    return gather(q).value(0);
  }
  /// The derivative of the table's w, whatever dw is.
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION Shape<T> with_own_derivative(T q) const {
    const Row<T> row = gather(q);
    return {row.value(0), lane_t<T>(intervals) * row.slope(0)};
  }
  KOKKOS_INLINE_FUNCTION double norm(int dimension) const { return norms_.in(dimension); }
  KOKKOS_INLINE_FUNCTION double norm_of_forces(int dimension) const { return force_norms_.in(dimension); }
  const char* name() const { return name_; }

 private:
  using Table = Kokkos::View<double* [8], Kokkos::LayoutRight>;

  /// Monomial coefficients of the w cubic (0 to 3) and the dw cubic (4 to 7) in every lane's interval, and the place t
  /// in [0, 1) inside it.
  template <class T>
  struct Row {
    T t, c[8];
    KOKKOS_FORCEINLINE_FUNCTION T value(int k) const { return c[k] + t * (c[k + 1] + t * (c[k + 2] + t * c[k + 3])); }
    KOKKOS_FORCEINLINE_FUNCTION T slope(int k) const {
      using R = lane_t<T>;
      return c[k + 1] + t * (R(2) * c[k + 2] + R(3) * t * c[k + 3]);
    }
  };

  /// Cubic through four equidistant values, the first at t = 0 and the last at t = 1.
  static void fit(double* c, double y0, double y1, double y2, double y3) {
    c[0] = y0;
    c[1] = (-11 * y0 + 18 * y1 - 9 * y2 + 2 * y3) / 2;
    c[2] = (18 * y0 - 45 * y1 + 36 * y2 - 9 * y3) / 2;
    c[3] = (-9 * y0 + 27 * y1 - 27 * y2 + 9 * y3) / 2;
  }

  /// Beyond the support the last row is taken: it is zero.
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION Row<T> gather(T q) const {
    using R = lane_t<T>;
    constexpr int L = lanes<T>;
    R x[L], t[L], c[8][L];
    store(x, T(R(intervals) * q));
    for (int lane = 0; lane < L; ++lane) {
      const int k = x[lane] < R(intervals) ? static_cast<int>(x[lane]) : intervals;
      t[lane] = k < intervals ? x[lane] - R(k) : R(0);
      for (int p = 0; p < 8; ++p) c[p][lane] = R(table_(k, p));
    }
    Row<T> row{load<T>(t), {}};
    for (int p = 0; p < 8; ++p) row.c[p] = load<T>(c[p]);
    return row;
  }

  Kokkos::View<const double* [8], Kokkos::LayoutRight> table_;
  struct Norms {
    double one, two, three;
    KOKKOS_INLINE_FUNCTION double in(int dimension) const {
      return dimension == 1 ? one : dimension == 2 ? two : three;
    }
  } norms_, force_norms_;
  char name_[16] = {};
};

}  // namespace sphk
