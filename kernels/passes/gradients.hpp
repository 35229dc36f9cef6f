// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "kernels/core/polynomial.hpp"
#include "kernels/passes/pair_loop.hpp"
#include "kernels/passes/step_passes.hpp"

namespace sphk {

namespace detail {

template <class S>
struct FitVelocity : PairLoop<S, List<Position, InverseSupport, Mass, Velocity>, Reach::symmetric> {
  using Base = PairLoop<S, List<Position, InverseSupport, Mass, Velocity>, Reach::symmetric>;
  using Base::D;
  using Base::state;
  using typename Base::Cell;
  using typename Base::Pack;
  using typename Base::T;
  using M = Monomials<D>;

  /// Fits are solved in double, one a lane.
  static constexpr int batch = native_lanes<double>;
  using Solver = PolynomialFit<simd<double, batch>, D, D>;
  /// Sums of a batch of particles: the moments, then the basis times each velocity component.
  static constexpr int sums_size = M::count + D * M::basis;
  /// Smallest pivot, relative to its diagonal, that is more than the rounding of the sums.
  static constexpr double degenerate = std::is_same_v<T, float> ? 1e-5 : 1e-12;
  /// Accumulators that stay in registers beside what a term needs.
  static constexpr int block = host_registers == 32 ? 24 : 12;

  explicit FitVelocity(const State<S>& of) : Base{of} {}

  void serve(Cell& cell, FitCounts& counts) const {
    double sums[cell_size / batch][sums_size][batch];
    const int begin = cell.begin();
    for (int first = begin; first < cell.end(); first += batch)
      if (cell.targets_of(first, batch) != 0) std::fill_n(&sums[(first - begin) / batch][0][0], sums_size * batch, 0.0);
    cell.for_each_target(
        true,
        [&](int i, const auto& tile, int, int) {
          add_sums(cell, i, tile, &sums[(i - begin) / batch][0][(i - begin) % batch]);
        },
        [](int) {});
    for (int first = begin; first < cell.end(); first += batch) {
      if (cell.targets_of(first, batch) == 0) continue;
      Solver fit;
      const auto quality = solve(fit, &sums[(first - begin) / batch][0][0]);
      for (int lane = 0; lane < batch && first + lane < cell.end(); ++lane)
        if (cell.is_target(first + lane)) store_lane(fit, lane, first + lane, quality, counts);
    }
  }

  KOKKOS_INLINE_FUNCTION void serve(const typename Base::Walk& walk, int i, FitCounts& counts) const {
    const auto target = walk.target(i);
    const T h_D = power_of_dimension<D>(1 / target.h_inv);
    double sums[sums_size] = {};
    walk.for_each(i, state.template at<Support>(i), [&](const auto& j) {
      const auto place = weigh(target, h_D, j);
      T share[sums_size] = {};
      add<0, M::count>(share, place);
      for (int c = 0; c < D; ++c) add_velocity(share + M::count + c * M::basis, place, j.v[c] - target.v[c]);
      for (int k = 0; k < sums_size; ++k) sums[k] += share[k];
    });
    PolynomialFit<double, D, D> fit;
    store_lane(fit, 0, i, solve(fit, sums), counts);
  }

 private:
  /// A neighbour as the fit of a particle sees it.
  template <class P>
  struct Place {
    P w;          ///< m_j Wbar of S12 eq 27 over (N_D/2) h_i^-D, which no fit feels
    Vec<P, D> x;  ///< (x_j - x_i)/h_i
  };
  /// h_D is h_i^D.
  template <class P>
  KOKKOS_FORCEINLINE_FUNCTION Place<P> weigh(const auto& i, const P& h_D, const auto& j) const {
    const P r = sphk::sqrt(j.r2);
    const P w_i = state.smoothing.kernel.w(r * i.h_inv), w_j = state.smoothing.kernel.w(r * j.h_inv);
    return {j.m * (w_i + h_D * power_of_dimension<D>(j.h_inv) * w_j), -i.h_inv * j.r_ij};
  }
  /// Adds the moments first, first + 1, ..., `size` of them.
  template <int first, int size, class P>
  KOKKOS_FORCEINLINE_FUNCTION static void add(P* sum, const Place<P>& at) {
    for_each_index<size>([&]<int s>() {
      constexpr auto factors = M::factors(first + s);
      sum[s] = sum[s] + (at.w * basis_value<D, factors.one>(at.x)) * basis_value<D, factors.other>(at.x);
    });
  }
  /// Adds the right-hand sides of a velocity component whose difference is dv.
  template <class P>
  KOKKOS_FORCEINLINE_FUNCTION static void add_velocity(P* sum, const Place<P>& at, const P& dv) {
    const P w_dv = at.w * dv;
    for_each_index<M::basis>([&]<int s>() { sum[s] = sum[s] + w_dv * basis_value<D, s>(at.x); });
  }

  /// More sums than registers: the list is passed several times. Weights and offsets take the place of 1/h and
  /// positions in it.
  using NeighbourList = typename Cell::CellTile;
  static Place<Pack> place(const NeighbourList& list, int k) {
    Place<Pack> at{list.template load<Pack, InverseSupport>(k), {}};
    for (int d = 0; d < D; ++d) at.x[d] = list.template load<Pack, Position>(k, d);
    return at;
  }

  void add_sums(const Cell& cell, int i, const NeighbourList& list, double* sums) const {
    const auto target = Base::target_of(cell, i);
    const Pack h_D = power_of_dimension<D>(Pack(T(1)) / target.h_inv);
    for (int k = 0; k < list.count; k += Cell::width) {
      const Place<Pack> at = weigh(target, h_D, list.template neighbours<Pack>(k, target.x));
      store(list.template row<InverseSupport>() + k, at.w);
      for (int d = 0; d < D; ++d) store(list.template row<Position>(d) + k, at.x[d]);
    }
    constexpr int blocks = (M::count + block - 1) / block;
    for_each_index<blocks>([&]<int b>() {
      constexpr int first = b * block, size = first + block < M::count ? block : M::count - first;
      sum_up<size>(list, sums + first * batch,
                   [](Pack* sum, int, const auto& at) SPHK_ALWAYS_INLINE { add<first, size>(sum, at); });
    });
    for (int c = 0; c < D; ++c)
      sum_up<M::basis>(list, sums + (M::count + c * M::basis) * batch,
                       [&](Pack* sum, int k, const auto& at) SPHK_ALWAYS_INLINE {
                         add_velocity(sum, at, list.template load<Pack, Velocity>(k, c) - target.v[c]);
                       });
  }
  template <int size>
  static void sum_up(const NeighbourList& list, double* sums, const auto& add_to) {
    Pack sum[size];
    for (Pack& each : sum) each = Pack(T(0));
    for (int k = 0; k < list.count; k += Cell::width) add_to(sum, k, place(list, k));
    for (int s = 0; s < size; ++s) sums[s * batch] += sum_lanes(sum[s]);
  }

  template <class P>
  struct Quality {
    P second_order, linear;
  };
  /// Solves the fits of a batch: second order where that is safe, else linear.
  template <class P>
  KOKKOS_INLINE_FUNCTION Quality<P> solve(PolynomialFit<P, D, D>& fit, const double* sums) const {
    P moments[M::count];
    for (int k = 0; k < M::count; ++k) moments[k] = load<P>(sums + k * lanes<P>);
    for (int c = 0; c < D; ++c)
      for (int k = 0; k < M::basis; ++k) fit.a[c][k] = load<P>(sums + (M::count + c * M::basis + k) * lanes<P>);
    fit.factor(moments);
    fit.solve(fit.quality < P(degenerate));
    return {fit.quality, fit.linear_quality};
  }

  template <class P>
  KOKKOS_INLINE_FUNCTION static double lane_of(const P& pack, int lane) {
    double numbers[lanes<P>];
    store(numbers, pack);
    return numbers[lane];
  }

  template <class P>
  KOKKOS_INLINE_FUNCTION void store_lane(const PolynomialFit<P, D, D>& fit, int lane, int i, const Quality<P>& quality,
                                         FitCounts& counts) const {
    const double h_inv = state.template at<InverseSupport>(i);
    const bool second_order = !(lane_of(quality.second_order, lane) < degenerate);
    Vec<double, D> gradient[D], grad_div;
    for (int c = 0; c < D; ++c) {
      grad_div[c] = 0;
      for (int d = 0; d < D; ++d) gradient[c][d] = lane_of(fit.a[c][1 + d], lane) * h_inv;
    }
    for_each_index<D>([&]<int c>() {
      for_each_index<D>([&]<int d>() {
        constexpr int k = M::second(c, d);
        grad_div[d] += (c == d ? 2 : 1) * lane_of(fit.a[c][k], lane) * h_inv * h_inv;
      });
    });
    if (!second_order) {
      if (lane_of(quality.linear, lane) < degenerate) {
        ++counts.sph;
        sph_estimate(i, gradient);
      } else {
        ++counts.linear;
      }
    }
    store_gradients(i, gradient, grad_div, second_order);
  }

  /// dv_c/dx_d = -(1/rho_i) sum_j m_j (v_i - v_j)_c dWbar/dx_d.
  KOKKOS_INLINE_FUNCTION void sph_estimate(int i, Vec<double, D>* gradient) const {
    const typename Base::Walk walk = Base::walk();
    const auto target = walk.target(i);
    const double rho_inv = 1 / state.template at<Density>(i);
    for (int c = 0; c < D; ++c)
      for (int d = 0; d < D; ++d) gradient[c][d] = 0;
    walk.for_each(i, state.template at<Support>(i), [&](const auto& j) {
      const auto ij = symmetric_pair<T, D>(state.smoothing, target, j);
      for (int c = 0; c < D; ++c)
        for (int d = 0; d < D; ++d) gradient[c][d] -= rho_inv * double(j.m * (target.v[c] - j.v[c]) * ij.grad_W[d]);
    });
  }

  KOKKOS_INLINE_FUNCTION void store_gradients(int i, const Vec<double, D>* gradient, Vec<double, D> grad_div,
                                              bool second_order) const {
    double div = 0;
    for (int d = 0; d < D; ++d) div += gradient[d][d];
    state.template at<VelocityDivergence>(i) = div;
    if constexpr (D == 3)
      for (int d = 0; d < 3; ++d) {
        const int a = (d + 1) % 3, b = (d + 2) % 3;
        state.template at<VelocityCurl>(i, d) = gradient[b][a] - gradient[a][b];
      }
    else if constexpr (D == 2)
      state.template at<VelocityCurl>(i) = gradient[1][0] - gradient[0][1];
    else
      state.template at<VelocityCurl>(i) = 0;
    // Without a second derivative, a converging flow is taken for one that changes over h: the switch then acts.
    if (!second_order) grad_div[0] = abs(div) * state.template at<InverseSupport>(i);
    for (int d = 0; d < D; ++d) state.template at<GradVelocityDivergence>(i, d) = grad_div[d];
  }
};

}  // namespace detail

template <class S>
FitCounts fit_velocities(const State<S>& state) {
  FitCounts counts;
  run_pairs("gradients", detail::FitVelocity<S>(state), Kokkos::Sum<FitCounts>(counts));
  return counts;
}

}  // namespace sphk
