#pragma once

#include "kernels/passes/pair_loop.hpp"
#include "kernels/passes/run.hpp"
#include "kernels/passes/state_equation.hpp"

namespace sphk {

/// A^(1/gamma).
struct EntropyRoot {
  static constexpr const char* name = "EntropyRoots";
  template <class T, int D>
  struct Value {
    T A_root;
  };
};

namespace detail {

/// sum_j m_j A_j^(1/gamma) Wbar, to the power of gamma.
template <class S>
struct SumRtPressure : PairLoop<S, List<Position, InverseSupport, Mass, EntropyRoot>, Reach::symmetric> {
  using Base = PairLoop<S, List<Position, InverseSupport, Mass, EntropyRoot>, Reach::symmetric>;
  using Base::D;
  using Base::state;
  using typename Base::Cell;
  using typename Base::Pack;
  using typename Base::T;

  explicit SumRtPressure(const State<S>& of) : Base{of} {}

  template <class P>
  KOKKOS_FORCEINLINE_FUNCTION P share(const auto& i, const auto& j, const P& h_inv_j) const {
    const P r = sphk::sqrt(j.r2);
    const P w_i = power_of_dimension<D>(i.h_inv) * state.smoothing.kernel.w(r * i.h_inv);
    const P w_j = power_of_dimension<D>(h_inv_j) * state.smoothing.kernel.w(r * h_inv_j);
    return j.m * j.A_root * (w_i + w_j);
  }
  KOKKOS_INLINE_FUNCTION void store_sum(int i, double sum) const {
    const double gamma = state.parameters.gamma;
    const double P = Kokkos::pow(0.5 * state.smoothing.norm * sum, gamma);
    state.template at<Pressure>(i) = P;
    state.template at<SoundSpeed>(i) = Kokkos::sqrt(gamma * P * state.template at<InverseDensity>(i));
  }

  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    if (!state.active.contains(i)) return;
    const typename Base::Walk walk{state.tree, state.columns};
    const auto target = walk.target(i);
    double sum = 0;
    walk.for_each(i, state.template at<Support>(i), [&](const auto& j) { sum += share<T>(target, j, j.h_inv); });
    store_sum(i, sum);
  }

  KOKKOS_INLINE_FUNCTION void operator()(const typename Base::Team& team) const {
    Cell cell = Base::cell_of(team);
    double sums[cell_size] = {};
    const int begin = cell.begin();
    cell.for_each_target(root(state.tree), [&](int i) { sums[i - begin] += sum_of(cell, i); });
    for (int i = begin; i < cell.end(); ++i)
      if (cell.is_target(i)) store_sum(i, sums[i - begin]);
  }

  double sum_of(Cell& cell, int i) const {
    const auto target = Base::target_of(cell, i);
    cell.list(target.x, state.template at<Support>(i));
    const auto& list = cell.neighbours();
    Pack sum = Pack(T(0));
    for (int k = 0; k < list.count; k += Cell::width) {
      const auto j = list.template load<Pack>(k);
      sum = sum + share<Pack>(target, j, j.h_inv);
    }
    return sum_lanes(sum);
  }
};

template <class L>
struct TakeEntropyRoot {
  Particles<L> state;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    state.template at<EntropyRoot>(i) = Kokkos::pow(state.template at<Thermal>(i), 1 / state.parameters.gamma);
  }
};

}  // namespace detail

/// The pressure of Ritchie & Thomas (2001), smooth by construction, in place of A rho^gamma: P_i = [sum_j m_j
/// A_j^(1/gamma) Wbar]^gamma (R10 eq 54; S12 eq 20). S12's App. A shows where it fails.
struct RtPressure {
  static constexpr const char* name = "RT pressure";
  static constexpr bool over_pairs = true;
  using Writes = List<>;
  using Keeps = List<EntropyRoot, Pressure, InverseDensity>;
  template <class S>
  static void run(RunOf<typename S::Layout>& run, const SmoothingOf<S>& smoothing) {
    static_assert(std::is_same_v<typename S::ThermalForm, EntropyForm>, "the RT pressure sums entropies");
    const State<S> state{run.state.template as<typename S::Layout>(), smoothing};
    Kokkos::parallel_for("entropy root", Kokkos::RangePolicy<ExecutionSpace>(0, state.n),
                         detail::TakeEntropyRoot<typename S::Layout>{state});
    run_pairs(name, detail::SumRtPressure<S>(state));
  }
};

}  // namespace sphk
