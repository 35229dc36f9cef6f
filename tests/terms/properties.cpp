// SPDX-License-Identifier: BSD-3-Clause

// What every term owes to the loops and to physics, for all terms of all schemes: nothing beyond reach, what it claims
// of action and reaction, Galilean invariance, and the same lines in a SIMD pack. A term enlists itself by standing in
// a recipe.
#include <gtest/gtest.h>

#include <random>

#include "all_schemes.hpp"
#include "kernels/smoothing/cubic_spline.hpp"
#include "kernels/terms/error_terms.hpp"
#include "kernels/terms/neighbour_count.hpp"

namespace sphk::test {
namespace {

template <class... R>
auto rate_terms(List<R...>) -> Union<typename R::RateTerms::List...>;
template <class... R>
auto density_sums(List<R...>) -> Union<typename R::DensityTerms::List...>;
template <class P>
auto sums_of(int) -> typename P::Sums::List;
template <class P>
auto sums_of(long) -> List<>;
template <class... P>
auto pass_sums(List<P...>) -> Union<decltype(sums_of<P>(0))...>;
template <class... R>
auto all_pass_sums(List<R...>) -> Union<decltype(pass_sums(typename R::StepPasses{}))...>;
template <class... S>
auto recipes_of(List<S...>) -> Union<typename S::Recipes...>;
using Recipes = decltype(recipes_of(AllSchemes{}));

template <class... T>
auto as_types(List<T...>) -> testing::Types<T...>;
/// Terms of the loops over r < max(h_i, h_j) and over r < h_i.
using PairTerms = decltype(as_types(
    Union<decltype(rate_terms(Recipes{})), List<ErrorTerms, NeighbourhoodTerms, NeighbourCountSum>>{}));
using GatherTerms = decltype(as_types(Union<decltype(density_sums(Recipes{})), decltype(all_pass_sums(Recipes{}))>{}));

/// Two particles with the fields that a term reads: each a number of its own between 1/2 and 3/2, velocities in
/// eighths.
template <class Term, class T>
struct Pair {
  using Fields = Union<List<Position, Velocity, Mass, InverseSupport, Separation, Distance2>, typename Term::Reads>;
  using Values = sphk::Values<T, 3, Fields>;
  Values i, j;

  Pair() {
    std::mt19937 engine(17);
    for (Values* one : {&i, &j})
      for_each_type(Fields{}, [&]<class F>() {
        for (int k = 0; k < components<F, 3>; ++k)
          component_array<F>(*one)[k] = T(0.5 + static_cast<double>(engine() % 8 + 1) / 8);
      });
    for (int k = 0; k < 3; ++k) i.v[k] = j.v[k] - T(0.25 * (k + 1));  // they approach
    i.h_inv = T(1) / T(2), j.h_inv = T(1) / T(3);
    if constexpr (contains<Support, Fields>) i.h = T(2), j.h = T(3);
    place(1.5);
  }
  /// i at this distance from j, along (3, 0, 4)/5.
  void place(double distance) {
    j.x = {{T(0.25), T(-0.5), T(1)}};
    i.x = {{T(0.25 + 0.6 * distance), T(-0.5), T(1 + 0.8 * distance)}};
  }
};

template <class T>
auto seen_from(const T& i, T j) {
  j.r_ij = i.x - j.x;
  j.r2 = dot(j.r_ij, j.r_ij);
  return j;
}

enum class Loop { symmetric, gather };

template <class Term, Loop loop, class T, class Values>
auto share(const Values& i, const Values& j) {
  sphk::Values<T, 3, typename Term::Adds> sum;
  set_zero(sum);
  const Smoothing<CubicSpline, 3> smoothing(CubicSpline{});
  const Term term(Given{});
  const Values neighbour = seen_from(i, j);
  if constexpr (loop == Loop::symmetric)
    term(sum, i, neighbour, symmetric_pair<T, 3>(smoothing, i, neighbour));
  else
    term(sum, i, neighbour, gather_pair<T, 3>(smoothing, i, neighbour));
  return sum;
}

template <class Sums>
void expect_nothing(const Sums& sum) {
  for_each_type(typename Sums::Fields{}, [&]<class F>() {
    for (int k = 0; k < components<F, 3>; ++k) EXPECT_EQ(component_array<F>(sum)[k], 0) << F::facts.name;
  });
}

template <class Sums>
void expect_equal(const Sums& a, const Sums& b) {
  for_each_type(typename Sums::Fields{}, [&]<class F>() {
    for (int k = 0; k < components<F, 3>; ++k)
      EXPECT_EQ(component_array<F>(a)[k], component_array<F>(b)[k]) << F::facts.name;
  });
}

/// The same pair in float packs: of each field, within 32 roundings of its largest component.
template <class Term, Loop loop>
void expect_same_in_a_pack() {
  using Pack = simd<float, native_lanes<float>>;
  const Pair<Term, double> pair;
  Pair<Term, Pack> packs;
  const auto wanted = share<Term, loop, double>(pair.i, pair.j);
  const auto got = share<Term, loop, Pack>(packs.i, packs.j);
  for_each_type(typename Term::Adds{}, [&]<class F>() {
    double scale = 0;
    for (int k = 0; k < components<F, 3>; ++k) scale = std::max(scale, std::abs(component_array<F>(wanted)[k]));
    for (int k = 0; k < components<F, 3>; ++k) {
      float lane[native_lanes<float>];
      store(lane, component_array<F>(got)[k]);
      for (const float value : lane)
        EXPECT_NEAR(value, component_array<F>(wanted)[k], 32 * 6e-8 * scale) << F::facts.name;
    }
  });
}

template <class Term, Loop loop>
void expect_galilean_invariance() {
  Pair<Term, double> pair;
  const auto at_rest = share<Term, loop, double>(pair.i, pair.j);
  for (auto* one : {&pair.i, &pair.j}) one->v[0] += 64, one->v[2] -= 32;  // leaves v_ij exact
  expect_equal(share<Term, loop, double>(pair.i, pair.j), at_rest);
}

template <class Term>
struct EveryPairTerm : testing::Test {};
TYPED_TEST_SUITE(EveryPairTerm, PairTerms);

TYPED_TEST(EveryPairTerm, AddsNothingBeyondReach) {
  Pair<TypeParam, double> pair;
  for (const double distance : {3.0, 3.0001, 50.0}) {  // h_i = 2, h_j = 3
    pair.place(distance);
    expect_nothing(share<TypeParam, Loop::symmetric, double>(pair.i, pair.j));
    expect_nothing(share<TypeParam, Loop::symmetric, double>(pair.j, pair.i));
  }
}
TYPED_TEST(EveryPairTerm, IsGalileanInvariant) {
  expect_galilean_invariance<TypeParam, Loop::symmetric>();
}
TYPED_TEST(EveryPairTerm, IsTheSameInAPack) {
  expect_same_in_a_pack<TypeParam, Loop::symmetric>();
}
TYPED_TEST(EveryPairTerm, KeepsWhatItClaimsOfActionAndReaction) {
  if constexpr (requires { typename TypeParam::Antisymmetric; }) {
    const Pair<TypeParam, double> pair;
    const auto on_i = share<TypeParam, Loop::symmetric, double>(pair.i, pair.j),
               on_j = share<TypeParam, Loop::symmetric, double>(pair.j, pair.i);
    for_each_type(typename TypeParam::Antisymmetric{}, [&]<class F>() {
      double scale = 0;
      for (int k = 0; k < components<F, 3>; ++k)
        scale = std::max(scale, std::abs(pair.i.m * component_array<F>(on_i)[k]));
      EXPECT_GT(scale, 0) << "the pair has to show something";
      for (int k = 0; k < components<F, 3>; ++k)
        EXPECT_NEAR(pair.i.m * component_array<F>(on_i)[k] + pair.j.m * component_array<F>(on_j)[k], 0, 1e-14 * scale)
            << F::facts.name;
    });
  }
}

template <class Term>
struct EveryGatherTerm : testing::Test {};
TYPED_TEST_SUITE(EveryGatherTerm, GatherTerms);

TYPED_TEST(EveryGatherTerm, AddsNothingBeyondReach) {
  Pair<TypeParam, double> pair;
  for (const double distance : {2.0, 2.0001, 50.0}) {
    pair.place(distance);
    expect_nothing(share<TypeParam, Loop::gather, double>(pair.i, pair.j));
  }
}
TYPED_TEST(EveryGatherTerm, IsGalileanInvariant) {
  expect_galilean_invariance<TypeParam, Loop::gather>();
}
TYPED_TEST(EveryGatherTerm, IsTheSameInAPack) {
  expect_same_in_a_pack<TypeParam, Loop::gather>();
}

}  // namespace
}  // namespace sphk::test
