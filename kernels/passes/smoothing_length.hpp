#pragma once

#include "kernels/passes/pair_loop.hpp"
#include "kernels/passes/support_search.hpp"
#include "kernels/terms/density.hpp"

namespace sphk {

/// How the searches of one pass went.
struct SupportCounts {
  long evaluations = 0;  ///< of n(h), over all particles
  long bisections = 0;   ///< particles that needed the safety net
  long capped = 0;       ///< particles that stay at h_max with too few neighbours
  long crowded = 0;      ///< coincident particles, more of them than neighbours asked
  long failed = 0;

  KOKKOS_INLINE_FUNCTION SupportCounts& operator+=(const SupportCounts& b) {
    evaluations += b.evaluations;
    bisections += b.bisections;
    capped += b.capped;
    crowded += b.crowded;
    failed += b.failed;
    return *this;
  }
  KOKKOS_INLINE_FUNCTION void count(const SupportSearch& search, SupportSearch::Result result) {
    evaluations += search.evaluations;
    bisections += search.bisected;
    capped += result == SupportSearch::Result::capped;
    crowded += result == SupportSearch::Result::crowded;
    failed += result == SupportSearch::Result::failed;
  }
};

namespace detail {

/// Sums of w(q) and q dw/dq over the neighbours of a particle at one trial h; n and dn/dh follow.
template <class T>
struct ShapeSums {
  T w, q_dw;
};

template <class S>
struct FindSupport : PairLoop<S, Union<List<Position>, typename S::DensityTerms::Reads>, Reach::gather> {
  using Terms = typename S::DensityTerms;
  using Base = PairLoop<S, Union<List<Position>, typename Terms::Reads>, Reach::gather>;
  using Base::D;
  using Base::state;
  using typename Base::Cell;
  using typename Base::Pack;
  using typename Base::T;
  using Found = Values<double, D, List<NumberDensity, NumberDensitySlope>>;
  using Sums = Values<double, D, typename Terms::Adds>;
  using Result = SupportSearch::Result;

  Terms terms;    ///< the further sums, taken once, at the final h
  double accept;  ///< relative move at which a search ends

  FindSupport(const State<S>& of, double relative) : Base{of}, terms(of.parameters), accept(relative) {}

  /// One particle's search.
  struct Task {
    SupportSearch search;
    ShapeSums<double> shapes{0, 0};
    Sums sums;
    Result result = Result::search;
    bool done = true;
  };

  template <class P>
  KOKKOS_FORCEINLINE_FUNCTION void add_shape(ShapeSums<P>& sums, const P& r2, const P& h_inv) const {
    const P q = sphk::sqrt(r2) * h_inv;
    const Shape<P> shape = with_own_derivative(state.smoothing.kernel, q);
    sums.w = sums.w + shape.w;
    sums.q_dw = sums.q_dw + q * shape.dw;
  }

  /// Takes n = N_D h^-D sum w and dn/dh = -N_D h^(-D-1) sum (D w + q dw) of the trial h to the next one.
  KOKKOS_INLINE_FUNCTION void advance(Task& task, int i) const {
    const Parameters& p = state.parameters;
    const double h_inv = 1 / task.search.h, scale = state.smoothing.norm * power_of_dimension<D>(h_inv);
    Found found;
    found.n = scale * task.shapes.w;
    found.dn_dh = -scale * h_inv * (D * task.shapes.w + task.shapes.q_dw);
    double move = 0;
    task.result = task.search.template advance<D>(found.n, found.dn_dh, p.neighbours, accept, p.h_max, move);
    if (task.result == Result::search) return;
    found.n += found.dn_dh * move;
    state.columns.store(i, found);
    state.template at<Support>(i) = task.search.h;
    state.template at<InverseSupport>(i) = 1 / task.search.h;
  }

  KOKKOS_INLINE_FUNCTION void finish(Task& task, int i, SupportCounts& counts) const {
    Sums& sums = task.sums;
    if constexpr (contains<Density, typename Terms::Adds>) {
      if constexpr (contains<VelocityDivergence, typename Terms::Adds>) sums.div_v /= sums.rho;
      if constexpr (contains<VelocityCurl, typename Terms::Adds>) sums.curl_v = (1 / sums.rho) * sums.curl_v;
    }
    state.columns.store(i, sums);
    task.done = true;
    counts.count(task.search, task.result);
  }

  /// One thread per particle: every evaluation walks the tree again.
  KOKKOS_INLINE_FUNCTION void operator()(int i, SupportCounts& counts) const {
    if (!state.active.contains(i)) return;
    const typename Base::Walk walk{state.tree, state.columns};
    auto values = walk.target(i);
    Task task;
    task.search = {state.template at<Support>(i)};
    while (task.result == Result::search) {
      const T h_inv = static_cast<T>(1 / task.search.h);
      task.shapes = {0, 0};
      walk.for_each(i, task.search.h, [&](const auto& j) {
        ShapeSums<T> pair{0, 0};
        add_shape(pair, j.r2, h_inv);
        task.shapes.w += pair.w;
        task.shapes.q_dw += pair.q_dw;
      });
      advance(task, i);
    }
    values.h_inv = static_cast<T>(1 / task.search.h);
    set_zero(task.sums);
    walk.for_each(i, task.search.h, [&](const auto& j) {
      Values<T, D, typename Terms::Adds> pair_sums;
      set_zero(pair_sums);
      terms(pair_sums, values, j, gather_pair<T, D>(state.smoothing, values, j));
      accumulate(task.sums, pair_sums);
    });
    finish(task, i, counts);
  }

  KOKKOS_INLINE_FUNCTION void operator()(const typename Base::Team& team, SupportCounts& counts) const {
    Cell cell = Base::cell_of(team);
    const Bounds<D> all = root(state.tree);
    Task tasks[cell_size];
    const int begin = cell.begin(), n = cell.end() - begin;
    for (int k = 0; k < n; ++k) {
      tasks[k].search = {state.template at<Support>(begin + k)};
      tasks[k].done = !cell.is_target(begin + k);
    }
    const auto largest = [&] {
      double h = 0;
      for (int k = 0; k < n; ++k)
        if (!tasks[k].done) h = max(h, tasks[k].search.h);
      return h;
    };
    double margin = 1.02;
    for (double h = largest(); h > 0; h = largest(), margin = 1.3) {
      bool in_one_tile = false;
      for (int k = 0; k < n; ++k) clear(tasks[k]);
      cell.collect(all, margin * h, [&](bool whole) {
        in_one_tile = whole;
        for (int s = cell.first_sub_cell(); s < cell.last_sub_cell(); ++s)
          sweep(cell, s, tasks, whole ? margin * h : 0, counts);
      });
      if (in_one_tile) continue;
      for (int k = 0; k < n; ++k)
        if (!tasks[k].done) {
          if (tasks[k].result == Result::search)
            advance(tasks[k], begin + k);
          else
            finish(tasks[k], begin + k, counts);
        }
    }
  }

  static void clear(Task& task) {
    task.shapes = {0, 0};
    set_zero(task.sums);
  }

  /// Where the tile holds everything within `whole_reach`, follows each search of a sub-cell as far as that goes;
  /// elsewhere adds the tile's share to one evaluation.
  void sweep(Cell& cell, int sub_cell, Task* tasks, double whole_reach, SupportCounts& counts) const {
    const int from = sub_cell * sub_cell_size, to = min(from + sub_cell_size, state.n), base = cell.begin();
    double reach = 0;
    for (int i = from; i < to; ++i)
      if (!tasks[i - base].done) reach = max(reach, tasks[i - base].search.h);
    if (reach == 0) return;
    reach = whole_reach > 0 ? min(1.02 * reach, whole_reach) : reach;
    cell.select(sub_cell, reach);
    for (int i = from; i < to; ++i) {
      Task& task = tasks[i - base];
      if (task.done) continue;
      if (whole_reach > 0)
        follow(cell, i, reach, task, counts);
      else
        add_share(cell, i, task);
    }
  }

  /// Searches as far as the candidates reach; the neighbours listed for one trial serve those near it as well.
  void follow(Cell& cell, int i, double reach, Task& task, SupportCounts& counts) const {
    const auto values = Base::target_of(cell, i);
    double listed = 0;
    while (task.result == Result::search && !(task.search.h > reach)) {  // a NaN is met and fails
      if (!(task.search.h <= listed)) {
        listed = min(1.01 * task.search.h, reach);
        cell.list(values.x, listed);
      }
      task.shapes = shapes(cell, task.search.h);
      advance(task, i);
    }
    if (task.result == Result::search) return;
    if (listed == 0) cell.list(values.x, task.search.h);
    add_terms(cell, values, task);
    finish(task, i, counts);
  }

  void add_share(Cell& cell, int i, Task& task) const {
    const auto values = Base::target_of(cell, i);
    cell.list(values.x, task.search.h);
    if (task.result != Result::search) return add_terms(cell, values, task);
    const ShapeSums<double> share = shapes(cell, task.search.h);
    task.shapes.w += share.w;
    task.shapes.q_dw += share.q_dw;
  }

  ShapeSums<double> shapes(const Cell& cell, double h) const {
    const auto& neighbours = cell.neighbours();
    const Pack h_inv = static_cast<T>(1 / h);
    ShapeSums<Pack> sums{Pack(T(0)), Pack(T(0))};
    const T* r2 = neighbours.template row<Distance2>();
    for (int k = 0; k < neighbours.count; k += Cell::width) add_shape(sums, load<Pack>(r2 + k), h_inv);
    return {sum_lanes(sums.w), sum_lanes(sums.q_dw)};
  }

  void add_terms(const Cell& cell, auto values, Task& task) const {
    if constexpr (Terms::List::size > 0) {
      const auto& neighbours = cell.neighbours();
      values.h_inv = Pack(static_cast<T>(1 / task.search.h));
      Values<Pack, D, typename Terms::Adds> packs;
      set_zero(packs);
      for (int k = 0; k < neighbours.count; k += Cell::width) {
        const auto j = neighbours.template load<Pack>(k);
        terms(packs, values, j, gather_pair<Pack, D>(state.smoothing, values, j));
      }
      accumulate(task.sums, packs);
    }
  }
};

}  // namespace detail

/// Support radii and number densities of the active particles by Newton's method from the present h (S12 eq 11), then
/// the scheme's further sums (rho and others) at the final h. A search ends when its step is below accept * h; n is
/// then carried over to first order.
template <class S>
SupportCounts find_support(const State<S>& state, double accept) {
  SupportCounts counts;
  run_pairs("smoothing length", detail::FindSupport<S>(state, accept), Kokkos::Sum<SupportCounts>(counts));
  return counts;
}

}  // namespace sphk

template <>
struct Kokkos::reduction_identity<sphk::SupportCounts> {
  KOKKOS_FORCEINLINE_FUNCTION static sphk::SupportCounts sum() { return {}; }
};
