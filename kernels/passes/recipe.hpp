// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "kernels/passes/state.hpp"

namespace sphk {

// What a scheme is before dimension, smoothing kernel and pair arithmetic are chosen, and the checks of it. A pass
// declares, all optional but the first two:
//   Reads         fields that a pass before it in the step writes
//   Writes        fields that it computes; those that nobody reads are neither allocated nor stored
//   Remembers     fields of the step before
//   MayRemember   the same, where the scheme has them
//   Keeps         fields that it stores whether or not anyone else reads them
//   essential     it does more than write fields
//   wanted(given) whether it runs at all, asked once a run

namespace detail {

// The lists that a pass may leave out, empty there.
template <class P>
auto keeps(int) -> typename P::Keeps;
template <class P>
auto keeps(long) -> List<>;
template <class P>
auto remembers(int) -> typename P::Remembers;
template <class P>
auto remembers(long) -> List<>;
template <class P>
auto may_remember(int) -> typename P::MayRemember;
template <class P>
auto may_remember(long) -> List<>;

/// Reads and Writes of pass P in recipe R: some follow from the recipe's sums and terms.
template <class P, class R>
struct PassIn {
  using Reads = typename P::Reads;
  using Writes = typename P::Writes;
};
template <class P, class R>
requires requires {
  typename P::template ReadsIn<R>;
}
struct PassIn<P, R> {
  using Reads = typename P::template ReadsIn<R>;
  using Writes = typename P::template WritesIn<R>;
};

template <class P>
inline constexpr bool is_essential = requires {
  P::essential;
};

}  // namespace detail

/// Passes in the order of a step.
template <class... P>
struct Passes {
  using List = sphk::List<P...>;
};

/// Form: EntropyForm or EnergyForm. DensitySums: what the density loop adds up beside n and rho. Terms: those of the
/// rates. Steps: Passes<...>. What is not listed is not compiled, not allocated, not run.
template <class Form, class DensitySums, class Terms, class Steps>
struct Recipe {
  using ThermalForm = Form;
  using DensityTerms = DensitySums;
  using RateTerms = Terms;
  using StepPasses = typename Steps::List;
  using LeftOut = List<>;
};

namespace detail {

template <class R, class... P>
auto read_in(List<P...>) -> Union<typename R::RateTerms::Reads, typename PassIn<P, R>::Reads...,
                                  decltype(remembers<P>(0))..., decltype(may_remember<P>(0))...>;
template <class R, class... P>
auto written_in(List<P...>) -> Union<typename PassIn<P, R>::Writes...>;
template <class... P>
auto kept_by(List<P...>) -> Union<decltype(keeps<P>(0))...>;

}  // namespace detail

/// Every field that a term or pass of recipe R reads.
template <class R>
using ReadIn = decltype(detail::read_in<R>(typename R::StepPasses{}));
template <class R>
using WrittenIn = decltype(detail::written_in<R>(typename R::StepPasses{}));
template <class R>
using KeptIn = decltype(detail::kept_by(typename R::StepPasses{}));

// The checks. Each is a struct of its own, so that the compiler names the pass and the field beside the sentence.

template <class Pass, class Field, bool written_before>
struct OrderOfPasses {
  static_assert(written_before,
                "Pass reads Field, which no pass before it in the step writes: put it behind the pass that does, or "
                "add one that does");
  static constexpr bool checked = true;
};
template <class Pass, class Field, bool written>
struct MemoryOfPasses {
  static_assert(written, "Pass remembers Field from the step before, but no pass of the step writes it");
  static constexpr bool checked = true;
};

namespace detail {

template <class Pass, class Known, class... F>
constexpr bool reads_are_known(List<F...>) {
  return (OrderOfPasses<Pass, F, contains<F, Known>>::checked && ...);
}
template <class Pass, class Written, class... F>
constexpr bool memory_is_written(List<F...>) {
  return (MemoryOfPasses<Pass, F, contains<F, Written>>::checked && ...);
}

template <class R, class Known>
constexpr bool are_in_order(List<>) {
  return true;
}
template <class R, class Known, class P, class... Rest>
constexpr bool are_in_order(List<P, Rest...>) {
  return reads_are_known<P, Known>(typename PassIn<P, R>::Reads{}) &&
         memory_is_written<P, WrittenIn<R>>(decltype(remembers<P>(0)){}) &&
         are_in_order<R, Union<Known, typename PassIn<P, R>::Writes>>(List<Rest...>{});
}

}  // namespace detail

/// Whether every pass of recipe R reads what passes before it write; where not, the compiler names both. Masses are
/// there from the start.
template <class R>
inline constexpr bool in_order = detail::are_in_order<R, List<Mass>>(typename R::StepPasses{});

namespace detail {

template <class T, class Left>
using IfKept = std::conditional_t<contains<T, Left>, List<>, List<T>>;
template <class Left, class... T>
auto without(List<T...>) -> Union<IfKept<T, Left>...>;
template <class... T>
auto term_set(List<T...>) -> TermSet<T...>;
template <class... T>
auto passes(List<T...>) -> Passes<T...>;
template <class... T>
auto added_by(List<T...>) -> Union<typename T::Adds...>;

/// Fields that terms Left add and no other term of recipe R does.
template <class R, class Left>
struct Lost {
  using Others = decltype(added_by(without<Left>(typename R::RateTerms::List{})));
  template <class F>
  using Gone = std::bool_constant<!contains<F, Others>>;
  using type = Filter<decltype(added_by(Left{})), Gone>;
};

template <class A, class B>
inline constexpr bool overlap = false;
template <class... A, class B>
inline constexpr bool overlap<List<A...>, B> = (contains<A, B> || ...);

/// Passes of R that read nothing that is lost.
template <class R, class Gone>
struct Fed {
  template <class P>
  using Keep = std::bool_constant<is_essential<P> || !overlap<typename PassIn<P, R>::Reads, Gone>>;
  using type = Filter<typename R::StepPasses, Keep>;
};

/// Passes and density sums of R that someone still reads, until nothing more falls away.
template <class R>
struct Pruned {
  template <class P>
  using NeededPass = std::bool_constant<is_essential<P> || overlap<typename PassIn<P, R>::Writes, ReadIn<R>>>;
  template <class S>
  using NeededSum = std::bool_constant<overlap<typename S::Adds, ReadIn<R>>>;
  using Kept = Filter<typename R::StepPasses, NeededPass>;
  using Sums = Filter<typename R::DensityTerms::List, NeededSum>;
  using Next =
      Recipe<typename R::ThermalForm, decltype(term_set(Sums{})), typename R::RateTerms, decltype(passes(Kept{}))>;
};
template <class R, class Next = typename Pruned<R>::Next>
struct Settled {
  using type = typename Settled<Next>::type;
};
template <class R>
struct Settled<R, R> {
  using type = R;
};

template <class Old, class New, class... T>
auto replaced(List<T...>) -> TermSet<std::conditional_t<std::is_same_v<T, Old>, New, T>...>;

template <class R, class Left>
struct Leaner {
  using Terms = decltype(term_set(without<Left>(typename R::RateTerms::List{})));
  using Steps = decltype(passes(typename Fed<R, typename Lost<R, Left>::type>::type{}));
  using type = typename Settled<Recipe<typename R::ThermalForm, typename R::DensityTerms, Terms, Steps>>::type;
};

}  // namespace detail

/// Recipe R without some of its terms, and without the passes and density sums that only they needed. It serves where
/// each of the terms says that it is idle.
template <class R, class... Term>
struct Without : detail::Leaner<R, List<Term...>>::type {
  using LeftOut = Union<typename R::LeftOut, List<Term...>>;
  static constexpr bool lean = true;
};

/// Recipe R with another term in place of one, and without the passes and density sums that this leaves idle. It serves
/// where the new term says so.
template <class R, class Old, class New>
struct Replacing : detail::Settled<Recipe<typename R::ThermalForm, typename R::DensityTerms,
                                          decltype(detail::replaced<Old, New>(typename R::RateTerms::List{})),
                                          decltype(detail::passes(typename R::StepPasses{}))>>::type {
  using LeftOut = typename R::LeftOut;
  static constexpr bool lean = true;
};

/// A recipe that does not say it is lean computes every term and pass of its scheme.
template <class R>
inline constexpr bool is_complete = !requires {
  R::lean;
};

namespace detail {

template <class T>
bool serves_one(const Given& given) {
  if constexpr (requires { T::serves(given); }) return T::serves(given);
  return true;
}

template <class T>
double stiffness_of_one(const Given& given) {
  if constexpr (requires { T::stiffness(given); }) return T::stiffness(given);
  return 1;
}

}  // namespace detail

/// How many times shorter than its Courant number says the steps of recipe R must be: explicit steps follow a
/// dissipation that is stronger than usual only so.
template <class R>
double stiffness(const Given& given) {
  return [&]<class... T>(List<T...>) {
    return std::max({1.0, detail::stiffness_of_one<T>(given)...});
  }(typename R::RateTerms::List{});
}

/// Does recipe R compute what a run with these numbers of this gas needs?
template <class R>
bool serves(const Given& given, const GasTraits& gas) {
  return [&]<class... T, class... Left>(List<T...>, List<Left...>) {
    return (detail::serves_one<T>(given) && ...) && (Left::idle(given, gas) && ...);
  }(typename R::RateTerms::List{}, typename R::LeftOut{});
}

}  // namespace sphk
