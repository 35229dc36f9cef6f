#pragma once

#include "kernels/passes/general_density.hpp"
#include "src/engine/error_sums.hpp"
#include "src/engine/host_columns.hpp"
#include "src/engine/scheme.hpp"

namespace sphk {

namespace detail {

/// phi of a scheme's pressure term, eta of its continuity equation, and whether it has such an equation of its own.
template <class Terms, class Steps>
struct FreeFunctionsOf;
template <class... Term, class... Pass>
struct FreeFunctionsOf<List<Term...>, Passes<Pass...>> {
  template <class... T>
  struct FirstPhi {
    using type = One;
  };
  template <class T, class... Rest>
  struct FirstPhi<T, Rest...> : FirstPhi<Rest...> {};
  template <class T, class... Rest>
  requires requires { typename T::Phi; }
  struct FirstPhi<T, Rest...> {
    using type = typename T::Phi;
  };
  template <class... P>
  struct FirstEta {
    using type = One;
    static constexpr bool found = false;
  };
  template <class P, class... Rest>
  struct FirstEta<P, Rest...> : FirstEta<Rest...> {};
  template <class P, class... Rest>
  requires requires { typename P::Eta; }
  struct FirstEta<P, Rest...> {
    using type = typename P::Eta;
    static constexpr bool found = true;
  };
  using Phi = typename FirstPhi<Term...>::type;
  using Eta = typename FirstEta<Pass...>::type;
  static constexpr bool general_density = FirstEta<Pass...>::found;
};

template <class L, class Phi, class Eta>
struct FillErrorColumns {
  static constexpr int D = L::dimension;
  Particles<L> state;
  Columns<D, typename ErrorLayout<D>::Fields> out;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    for (int d = 0; d < D; ++d) out.template at<Position>(i, d) = state.template at<Position>(i, d);
    const double h = state.template at<Support>(i);
    const GasValues gas = gas_values(state, i, state.state_density(i));
    out.template at<Mass>(i) = state.template at<Mass>(i);
    out.template at<Support>(i) = h;
    out.template at<InverseSupport>(i) = 1 / h;
    out.template at<Density>(i) = gas.rho;
    out.template at<InversePhi>(i) = positive(1 / Phi::value(gas));
    out.template at<InverseEta>(i) = positive(1 / Eta::value(gas));
    out.template at<Entropy>(i) = gas.A;
  }
  /// Of gas without heat 1/u is infinite: a ratio of such particles is 1 then, not NaN.
  KOKKOS_INLINE_FUNCTION static double positive(double x) { return max(x, 1e-150); }
};

/// A symmetric matrix as xx, yy, zz, xy, xz, yz; those of the axes that there are, the others zero.
template <class F, int D>
Field matrix_field(const HostRows& rows, std::string name, std::string description) {
  constexpr int first = component_offset<D, F, typename ErrorColumns<D>::Fields>;
  constexpr int places[3][6] = {{0}, {0, 1, 3}, {0, 1, 2, 3, 4, 5}};
  Field out{std::move(name), std::move(description), {}, 6, std::vector<double>(6 * rows.order.size())};
  for (std::size_t i = 0; i < rows.order.size(); ++i)
    for (int k = 0; k < symmetric_size<D>; ++k)
      out.values[6 * i + static_cast<std::size_t>(places[D - 1][k])] = rows.at(static_cast<int>(i), first + k);
  return out;
}

template <class F, int D, class Value>
Field scalar_field(const HostRows& rows, std::string name, std::string description, UnitExponents units, Value value) {
  Field out{std::move(name), std::move(description), units, 1, std::vector<double>(rows.order.size())};
  for (std::size_t i = 0; i < rows.order.size(); ++i)
    out.values[i] = value(rows.at(static_cast<int>(i), component_offset<D, F, typename ErrorColumns<D>::Fields>));
  return out;
}

}  // namespace detail

/// Phi, Eta and general_density of scheme S.
template <class S>
using FreeFunctionsOf = detail::FreeFunctionsOf<typename S::RateTerms::List, typename S::Steps>;

/// E0, R and V of every particle (R10 eq 28-30), how unlike its neighbours' entropies are and how near the nearest is,
/// by id. Cells and supports are those of the last step.
template <class S>
std::vector<Field> error_fields(const Particles<typename S::Layout>& state, const SmoothingOf<S>& smoothing) {
  constexpr int D = S::dimension;
  using L = typename S::Layout;
  using Functions = FreeFunctionsOf<S>;
  Particles<ErrorLayout<D>> particles{state.n, Columns<D, typename ErrorLayout<D>::Fields>("errors", state.n),
                                      state.ids, state.tree, state.parameters};
  Kokkos::parallel_for(
      "columns for errors", Kokkos::RangePolicy<ExecutionSpace>(0, state.n),
      detail::FillErrorColumns<L, typename Functions::Phi, typename Functions::Eta>{state, particles.columns});
  const ErrorColumns<D> sums = error_sums<D, typename S::Kernel>(particles, smoothing);
  const HostRows rows(sums.data, sums.stride, state.ids);
  std::vector<Field> fields;
  fields.push_back(rows.field("E0", "Zeroth-order error of the force (R10 eq 28)", {}, 3, 0, D, 0));
  fields.push_back(detail::matrix_field<ErrorR, D>(rows, "R", "Error matrix of the continuity equation (R10 eq 29)"));
  fields.push_back(detail::matrix_field<ErrorV, D>(rows, "V", "Error matrix of the momentum equation (R10 eq 29)"));
  fields.push_back(detail::scalar_field<EntropyContrast, D>(
      rows, "EntropyContrast", "Largest |ln(A_i/A_j)| over neighbours with r < h", {},
      [](double ratio) { return ratio > 1 ? std::log(ratio) : 0; }));
  fields.push_back(detail::scalar_field<InverseNearest, D>(
      rows, "NearestNeighbour", "Distance of the nearest neighbour; 0: none within h", {1, 0, 0},
      [](double inverse) { return inverse > 0 ? 1 / inverse : 0; }));
  return fields;
}

}  // namespace sphk
