// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <iterator>
#include <utility>

#include "src/engine/passes_of.hpp"
#include "src/schemes/instantiation.hpp"
#include "src/schemes/kernel_table.hpp"
#include "src/schemes/shared_loops.hpp"

namespace sphk {

namespace detail {

template <class K>
K make_kernel(const std::string& name) {
  if constexpr (std::is_same_v<K, Tabulated>)
    return kernel_table(name);
  else
    return K{};
}

template <class S>
std::unique_ptr<Simulation> make_engine(const ParticleSet& particles, const SimulationSettings& settings) {
  return make_run<BaseLayout<typename S::Layout>>(
      particles, settings, std::make_unique<PassesOf<S>>(make_kernel<typename S::Kernel>(settings.kernel)));
}

template <class T>
constexpr TermFacts term_facts() {
  if constexpr (requires(const Given& given, const GasTraits& gas) { T::idle(given, gas); })
    return {T::name, &T::idle};
  else
    return {T::name, +[](const Given&, const GasTraits&) { return false; }};
}

template <class... T>
std::vector<TermFacts> all_term_facts(List<T...>) {
  return {term_facts<T>()...};
}

template <int D, class... F>
std::vector<FieldPlace> all_places(List<F...>) {
  return {FieldPlace{&F::facts, 0, components<F, D>}...};
}

template <class K, int D>
double self_term() {
  if constexpr (std::is_same_v<K, Tabulated>)
    return 0;
  else
    return unit_sphere<D> * K{}.norm(D) * K{}(0.0).w;
}

template <class Facts, class R, int D, class T, class... K>
void append(Instantiations& rows, List<K...>) {
  [[maybe_unused]] const auto add = [&]<class Kernel>() {
    using S = Scheme<R, D, Kernel, T>;
    const char* kernel = nullptr;
    if constexpr (!std::is_same_v<Kernel, Tabulated>) kernel = Kernel::name;
    rows.push_back({.scheme = &Facts::facts,
                    .energy = R::ThermalForm::name,
                    .dimension = D,
                    .precision = std::is_same_v<T, float> ? "mixed" : "double",
                    .kernel = kernel,
                    .complete = is_complete<R>,
                    .flops = flops_per_pair<S>(),
                    .self_term = self_term<Kernel, D>(),
                    .serves = &serves<R>,
                    .make = &make_engine<S>,
                    .facts = &facts_of<S>,
                    .terms = all_term_facts(typename R::RateTerms::List{}),
                    .written = all_places<D>(WrittenIn<R>{}),
                    .left_out = R::ThermalForm::left_out});
  };
  (add.template operator()<K>(), ...);
}

/// The number types of pairs that recipe R is compiled for.
template <class R>
struct PairNumbersOf {
  using type = List<float, double>;
};
template <class R>
requires requires {
  typename R::PairNumbers;
}
struct PairNumbersOf<R> {
  using type = typename R::PairNumbers;
};

template <class S, int D, class T, class... R>
void append_recipes(Instantiations& rows, List<R...>) {
  const auto add = [&]<class One>() {
    if constexpr (contains<T, typename PairNumbersOf<One>::type>)
      append<S, One, D, T>(rows, typename One::Kernels::template in<D>{});
  };
  (add.template operator()<R>(), ...);
}

}  // namespace detail

template <class S, int D, class T>
Instantiations instantiate() {
  Instantiations rows;
  detail::append_recipes<S, D, T>(rows, typename S::Recipes{});
  return rows;
}

/// All rows of scheme S.
template <class S>
Instantiations all_rows_of() {
  Instantiations rows = rows_of<S, 1>();
  std::ranges::move(rows_of<S, 2>(), std::back_inserter(rows));
  std::ranges::move(rows_of<S, 3>(), std::back_inserter(rows));
  return rows;
}

}  // namespace sphk
