// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/passes/pair_loop.hpp"
#include "kernels/passes/step_passes.hpp"
#include "kernels/terms/velocity_gradient.hpp"

namespace sphk {

namespace detail {

/// Sums over the neighbours of a particle at one trial h, without the norm: n, rho and their slopes in h follow.
template <class T>
struct ShapeSums {
  T w, q_dw;      ///< of w(q) and q dw/dq
  T m_w, m_q_dw;  ///< the same times m_j

  template <class U>
  KOKKOS_FORCEINLINE_FUNCTION void operator+=(const ShapeSums<U>& b) {
    w = w + T(b.w);
    q_dw = q_dw + T(b.q_dw);
    m_w = m_w + T(b.m_w);
    m_q_dw = m_q_dw + T(b.m_q_dw);
  }
};

template <class S>
struct FindSupport : PairLoop<S, Union<List<Position, Mass>, typename S::DensityTerms::Reads>, Reach::gather> {
  using Terms = typename S::DensityTerms;
  using Base = PairLoop<S, Union<List<Position, Mass>, typename Terms::Reads>, Reach::gather>;
  using Base::D;
  using Base::state;
  using typename Base::Cell;
  using typename Base::Pack;
  using typename Base::T;
  using Adds = typename Terms::Adds;
  using Result = SupportSearch::Result;

  Terms terms;    ///< the further sums, taken once, at the final h
  double accept;  ///< relative move at which a search ends

  FindSupport(const State<S>& of, const Given& given, double relative) : Base{of}, terms(given), accept(relative) {}

  /// One particle's search.
  struct Task {
    SupportSearch search;
    ShapeSums<double> shapes;
    Values<double, D, Adds> sums;
    Result result;
    bool done;
  };

  /// What j adds at a trial h.
  template <class P>
  KOKKOS_FORCEINLINE_FUNCTION void visit(ShapeSums<P>& sums, const P& h_inv, const auto& j) const {
    const P q = sphk::sqrt(j.r2) * h_inv;
    const Shape<P> shape = with_own_derivative(state.smoothing.kernel, q);
    const P q_dw = q * shape.dw;
    sums += ShapeSums<P>{shape.w, q_dw, j.m * shape.w, j.m * q_dw};
  }
  /// What j adds to the further sums, at the final h.
  template <class P>
  KOKKOS_FORCEINLINE_FUNCTION void visit(Values<P, D, Adds>& sums, const auto& i, const auto& j) const {
    terms(sums, i, j, gather_pair<P, D>(state.smoothing, i, j));
  }

  /// Takes n = N_D h^-D sum w (S12 eq 11) and dn/dh = -N_D h^(-D-1) sum (D w + q dw) of the trial h to the next one;
  /// at the end of the search stores them and rho = N_D h^-D sum m_j w (S12 eq 6), carried over the last move.
  KOKKOS_INLINE_FUNCTION void advance(Task& task, int i) const {
    const Parameters& p = state.parameters;
    const ShapeSums<double>& sums = task.shapes;
    const double h_inv = 1 / task.search.h, scale = state.smoothing.norm * power_of_dimension<D>(h_inv);
    const double n = scale * sums.w, dn_dh = -scale * h_inv * (D * sums.w + sums.q_dw);
    const double rho = scale * sums.m_w, drho_dh = -scale * h_inv * (D * sums.m_w + sums.m_q_dw);
    double move = 0;
    task.result = task.search.template advance<D>(n, dn_dh, p.neighbours, accept, p.h_max, move);
    if (task.result == Result::search) return;
    state.template at<NumberDensity>(i) = n + dn_dh * move;
    state.template at<NumberDensitySlope>(i) = dn_dh;
    state.template at<Density>(i) = rho + drho_dh * move;
    if constexpr (contains<DensitySlope, typename S::Fields>) state.template at<DensitySlope>(i) = drho_dh;
    state.template at<Support>(i) = task.search.h;
    state.template at<InverseSupport>(i) = 1 / task.search.h;
  }

  KOKKOS_INLINE_FUNCTION void finish(Task& task, int i, SupportCounts& counts) const {
    auto& sums = task.sums;
    const double rho = state.template at<Density>(i);
    if constexpr (contains<VelocityDivergence, Adds>) sums.div_v /= rho;
    if constexpr (contains<VelocityCurl, Adds>) sums.curl_v = (1 / rho) * sums.curl_v;
    state.columns.store(i, sums);
    task.done = true;
    counts.count(task.search, task.result);
  }

  /// One thread per particle: every evaluation walks the tree again.
  KOKKOS_INLINE_FUNCTION void serve(const typename Base::Walk& walk, int i, SupportCounts& counts) const {
    auto target = walk.target(i);
    Task task;
    start(task, i);
    while (task.result == Result::search) {
      const T h_inv = static_cast<T>(1 / task.search.h);
      task.shapes = {};
      walk.for_each(i, task.search.h, [&](const auto& j) {
        ShapeSums<T> share{};
        visit(share, h_inv, j);
        task.shapes += share;
      });
      advance(task, i);
    }
    target.h_inv = static_cast<T>(1 / task.search.h);
    set_zero(task.sums);
    walk.for_each(i, task.search.h, [&](const auto& j) {
      Values<T, D, Adds> share;
      set_zero(share);
      visit(share, target, j);
      accumulate(task.sums, share);
    });
    finish(task, i, counts);
  }

  void serve(Cell& cell, SupportCounts& counts) const {
    Task tasks[cell_size];
    const auto for_each_task = [&](auto&& f) {
      for_each_of(cell.targets(), cell.begin(), [&](int i) { f(tasks[i - cell.begin()], i); });
    };
    for_each_task([&](Task& task, int i) { start(task, i); });
    const auto largest = [&] {
      double h = 0;
      for_each_task([&](const Task& task, int) { h = task.done ? h : max(h, task.search.h); });
      return h;
    };
    double margin = 1.02;
    for (double h = largest(); h > 0; h = largest(), margin = 1.3) {
      bool in_one_tile = false;
      for_each_task([](Task& task, int) { clear(task); });
      cell.collect(margin * h, [&](bool whole) {
        in_one_tile = whole;
        for (int s = cell.first_sub_cell(); s < cell.last_sub_cell(); ++s)
          sweep(cell, s, tasks, whole ? margin * h : 0, counts);
      });
      if (in_one_tile) continue;
      for_each_task([&](Task& task, int i) {
        if (task.done) return;
        if (task.result == Result::search)
          advance(task, i);
        else
          finish(task, i, counts);
      });
    }
  }

  KOKKOS_INLINE_FUNCTION void start(Task& task, int i) const {
    task.search = {state.template at<Support>(i)};
    task.result = Result::search;
    task.done = false;
  }
  static void clear(Task& task) {
    task.shapes = {};
    set_zero(task.sums);
  }

  /// Where the tile holds everything within `whole_reach`, follows each search of a sub-cell as far as that goes;
  /// elsewhere adds the tile's share to one evaluation.
  void sweep(Cell& cell, int sub_cell, Task* tasks, double whole_reach, SupportCounts& counts) const {
    const auto for_each_open = [&](auto&& f) {
      const int from = sub_cell * sub_cell_size, base = cell.begin();
      for_each_of(cell.targets_of(from, sub_cell_size), from, [&](int i) {
        if (!tasks[i - base].done) f(tasks[i - base], i);
      });
    };
    double reach = 0;
    for_each_open([&](const Task& task, int) { reach = max(reach, task.search.h); });
    if (reach == 0) return;
    reach = whole_reach > 0 ? min(1.02 * reach, whole_reach) : reach;
    const bool few = cell.select(sub_cell, reach);
    const bool listed = !cell.has_one_target() && (!few || Base::lists_pay() || Terms::List::size > 0);
    for_each_open([&](Task& task, int i) {
      if (whole_reach > 0)
        follow(cell, i, reach, listed, task, counts);
      else
        add_share(cell, i, task);
    });
  }

  /// Searches as far as the candidates reach; neighbours that are listed for one trial serve those near it as well.
  void follow(Cell& cell, int i, double reach, bool listed, Task& task, SupportCounts& counts) const {
    auto target = Base::target_of(cell, i);
    const auto& tile = listed ? cell.neighbours() : cell.candidates();
    double reached = listed ? 0 : reach;
    const auto reach_for = [&](double h) {
      if (h <= reached) return;
      reached = min(1.01 * h, reach);
      cell.list(target.x, reached);
    };
    while (task.result == Result::search && !(task.search.h > reach)) {  // a NaN is met and fails
      reach_for(task.search.h);
      task.shapes = shapes(tile, target, task.search.h);
      advance(task, i);
    }
    if (task.result == Result::search) return;
    reach_for(task.search.h);
    add_terms(tile, target, task);
    finish(task, i, counts);
  }

  /// One evaluation, of what the tile holds.
  void add_share(Cell& cell, int i, Task& task) const {
    auto target = Base::target_of(cell, i);
    cell.list(target.x, task.search.h);
    if (task.result != Result::search) return add_terms(cell.neighbours(), target, task);
    task.shapes += shapes(cell.neighbours(), target, task.search.h);
  }

  ShapeSums<double> shapes(const auto& tile, auto& target, double h) const {
    const Pack zero = T(0);
    target.h_inv = Pack(static_cast<T>(1 / h));
    ShapeSums<Pack> sums{zero, zero, zero, zero};
    Cell::for_each_pack(tile, 0, tile.count, target,
                        [&](const auto& j) SPHK_ALWAYS_INLINE { visit(sums, target.h_inv, j); });
    return {sum_lanes(sums.w), sum_lanes(sums.q_dw), sum_lanes(sums.m_w), sum_lanes(sums.m_q_dw)};
  }

  void add_terms(const auto& tile, auto& target, Task& task) const {
    if constexpr (Terms::List::size > 0) {
      target.h_inv = Pack(static_cast<T>(1 / task.search.h));
      Values<Pack, D, Adds> packs;
      set_zero(packs);
      Cell::for_each_pack(tile, 0, tile.count, target,
                          [&](const auto& j) SPHK_ALWAYS_INLINE { visit(packs, target, j); });
      accumulate(task.sums, packs);
    }
  }
};

}  // namespace detail

template <class S>
SupportCounts find_support(const State<S>& state, const Given& given, double accept) {
  SupportCounts counts;
  run_pairs("smoothing length", detail::FindSupport<S>(state, given, accept), Kokkos::Sum<SupportCounts>(counts));
  return counts;
}

}  // namespace sphk
