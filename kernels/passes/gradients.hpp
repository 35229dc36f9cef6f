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

  KOKKOS_INLINE_FUNCTION void operator()(const typename Base::Team& team, FitCounts& counts) const {
    Base::for_targets_of(team, [&](Cell& cell) { fit(cell, counts); });
  }
  void fit(Cell& cell, FitCounts& counts) const {
    double sums[cell_size / batch][sums_size][batch];
    const int begin = cell.begin();
    for (int first = begin; first < cell.end(); first += batch)
      if (cell.has_targets(first, batch)) std::fill_n(&sums[(first - begin) / batch][0][0], sums_size * batch, 0.0);
    cell.for_each_target(root(state.tree),
                         [&](int i) { add_sums(cell, i, &sums[(i - begin) / batch][0][(i - begin) % batch]); });
    for (int first = begin; first < cell.end(); first += batch) {
      if (!cell.has_targets(first, batch)) continue;
      Solver fit;
      const auto quality = solve(fit, &sums[(first - begin) / batch][0][0]);
      for (int lane = 0; lane < batch && first + lane < cell.end(); ++lane)
        if (cell.is_target(first + lane)) store_lane(fit, lane, first + lane, quality, counts);
    }
  }

  /// One thread per particle.
  KOKKOS_INLINE_FUNCTION void operator()(int i, FitCounts& counts) const {
    if (!state.active.contains(i)) return;
    const typename Base::Walk walk{state.tree, state.columns};
    const auto target = walk.target(i);
    const T h_D = power_of_dimension<D>(1 / target.h_inv);
    double sums[sums_size] = {};
    walk.for_each(i, state.template at<Support>(i), [&](const auto& j) {
      const T w = weight(target, h_D, j.r2, j.h_inv, j.m);
      const Vec<T, D> x = -target.h_inv * j.r_ij;
      for_each_index<M::count>([&]<int k>() { sums[k] += moment<k>(w, x); });
      for (int c = 0; c < D; ++c) {
        const T w_dv = w * (j.v[c] - target.v[c]);
        for_each_index<M::basis>([&]<int k>() { sums[M::count + c * M::basis + k] += w_dv * basis_value<D, k>(x); });
      }
    });
    PolynomialFit<double, D, D> fit;
    store_lane(fit, 0, i, solve(fit, sums), counts);
  }

 private:
  /// m_j Wbar of S12 eq 27 over (N_D/2) h_i^-D, which no fit feels; h_D is h_i^D.
  template <class P>
  KOKKOS_FORCEINLINE_FUNCTION P weight(const auto& i, const P& h_D, const P& r2, const P& h_inv, const P& m) const {
    const P r = sphk::sqrt(r2);
    const P w_i = state.smoothing.kernel.w(r * i.h_inv), w_j = state.smoothing.kernel.w(r * h_inv);
    return m * (w_i + h_D * power_of_dimension<D>(h_inv) * w_j);
  }
  template <int k, class P>
  KOKKOS_FORCEINLINE_FUNCTION static P moment(const P& w, const Vec<P, D>& x) {
    constexpr auto factors = M::factors(k);
    return (w * basis_value<D, factors.one>(x)) * basis_value<D, factors.other>(x);
  }

  /// Where the weight and the offsets (x_j - x_i)/h_i replace r^2 and r_ij in the list of neighbours.
  static Vec<Pack, D> offset(const typename Cell::Neighbours& list, int k) {
    Vec<Pack, D> x;
    for (int d = 0; d < D; ++d) x[d] = load<Pack>(list.template row<Separation>(d) + k);
    return x;
  }
  static Pack weight_of(const typename Cell::Neighbours& list, int k) {
    return load<Pack>(list.template row<Distance2>() + k);
  }

  void add_sums(Cell& cell, int i, double* sums) const {
    const auto target = Base::target_of(cell, i);
    cell.list(target.x, state.template at<Support>(i));
    const auto& list = cell.neighbours();
    const Pack h_D = power_of_dimension<D>(Pack(T(1)) / target.h_inv);
    for (int k = 0; k < list.count; k += Cell::width) {
      const Pack w = weight(target, h_D, weight_of(list, k), load<Pack>(list.template row<InverseSupport>() + k),
                            load<Pack>(list.template row<Mass>() + k));
      const Vec<Pack, D> x = -target.h_inv * offset(list, k);
      store(list.template row<Distance2>() + k, w);
      for (int d = 0; d < D; ++d) store(list.template row<Separation>(d) + k, x[d]);
    }
    constexpr int blocks = (M::count + block - 1) / block;
    for_each_index<blocks>([&]<int b>() {
      constexpr int first = b * block, size = first + block < M::count ? block : M::count - first;
      add_moments<first, size>(list, sums);
    });
    for (int c = 0; c < D; ++c) add_velocity(list, c, target.v[c], sums);
  }

  template <int first, int size>
  static void add_moments(const typename Cell::Neighbours& list, double* sums) {
    Pack sum[size];
    for (Pack& each : sum) each = Pack(T(0));
    for (int k = 0; k < list.count; k += Cell::width) {
      const Pack w = weight_of(list, k);
      const Vec<Pack, D> x = offset(list, k);
      for_each_index<size>([&]<int s>() { sum[s] = sum[s] + moment<first + s>(w, x); });
    }
    for (int s = 0; s < size; ++s) sums[(first + s) * batch] += sum_lanes(sum[s]);
  }
  static void add_velocity(const typename Cell::Neighbours& list, int c, const Pack& v, double* sums) {
    Pack sum[M::basis];
    for (Pack& each : sum) each = Pack(T(0));
    for (int k = 0; k < list.count; k += Cell::width) {
      const Pack w_dv = weight_of(list, k) * (load<Pack>(list.template row<Velocity>(c) + k) - v);
      const Vec<Pack, D> x = offset(list, k);
      for_each_index<M::basis>([&]<int s>() { sum[s] = sum[s] + w_dv * basis_value<D, s>(x); });
    }
    for (int s = 0; s < M::basis; ++s) sums[(M::count + c * M::basis + s) * batch] += sum_lanes(sum[s]);
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
    const typename Base::Walk walk{state.tree, state.columns};
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
