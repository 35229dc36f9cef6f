// SPDX-License-Identifier: BSD-3-Clause

// What every term owes to physics, on two particles: action and reaction, Galilean invariance, nothing from a uniform
// state at rest, nothing from coincident particles, and the same lines in a SIMD pack.
#include <cmath>

#include "tests/terms/two_particles.hpp"

namespace sphk::test {
namespace {

template <class Term>
struct Symmetries : testing::Test {};
using ForceTerms =
    testing::Types<PressureGradientSph, PressureGradientTsph, PressureGradientConservative, ViscosityGingoldMonaghan<>,
                   ViscositySignalVelocity<>, ViscositySwitched<>, TensileCorrection>;
TYPED_TEST_SUITE(Symmetries, ForceTerms);

TYPED_TEST(Symmetries, ActionIsMinusReaction) {
  const TwoParticles<double, 3> p;
  const auto on_i = share<TypeParam, double, 3>(p.i, p.j), on_j = share<TypeParam, double, 3>(p.j, p.i);
  for (int d = 0; d < 3; ++d)
    EXPECT_NEAR(p.i.m * on_i.a[d], -p.j.m * on_j.a[d], 1e-15 * std::abs(p.i.m * on_i.a[0])) << "component " << d;
}

TYPED_TEST(Symmetries, IsGalileanInvariant) {
  TwoParticles<double, 3> p;
  const auto at_rest = share<TypeParam, double, 3>(p.i, p.j);
  // A boost by a power of two leaves v_ij exact.
  for (auto* particle : {&p.i, &p.j}) particle->v[0] += 64, particle->v[1] -= 32;
  const auto boosted = share<TypeParam, double, 3>(p.i, p.j);
  for (int d = 0; d < 3; ++d) EXPECT_EQ(at_rest.a[d], boosted.a[d]);
}

TYPED_TEST(Symmetries, LeavesCoincidentParticlesAlone) {
  TwoParticles<double, 3> p;
  p.i.x = p.j.x;
  const auto sum = share<TypeParam, double, 3>(p.i, p.j);
  for (int d = 0; d < 3; ++d) EXPECT_EQ(sum.a[d], 0);
}

TYPED_TEST(Symmetries, IsTheSameInEveryLaneOfAPack) {
  using Pack = simd<float, native_lanes<float>>;
  const TwoParticles<float, 3> one;
  const TwoParticles<double, 3> exact;
  Particle<Pack, 3> i, j;
  for (auto [from, to] : {std::pair(&one.i, &i), std::pair(&one.j, &j)})
    for_each_type(Everything{}, [from = from, to = to]<class F>() {
      for (int k = 0; k < components<F, 3>; ++k) component_array<F>(*to)[k] = Pack(component_array<F>(*from)[k]);
    });
  const auto packs = share<TypeParam, Pack, 3>(i, j);
  const auto wanted = share<TypeParam, double, 3>(exact.i, exact.j);
  float lane[native_lanes<float>];
  for (int d = 0; d < 3; ++d) {
    store(lane, packs.a[d]);
    for (const float value : lane) EXPECT_NEAR(value, wanted.a[d], 2e-6 * std::abs(wanted.a[0])) << "component " << d;
  }
}

template <class Term>
struct Dissipation : testing::Test {};
using DissipationTerms = testing::Types<ViscosityGingoldMonaghan<>, ViscositySignalVelocity<>, ViscositySwitched<>>;
TYPED_TEST_SUITE(Dissipation, DissipationTerms);

TYPED_TEST(Dissipation, ConservesEnergyAndHeats) {
  const TwoParticles<double, 3> p;
  const auto on_i = share<TypeParam, double, 3>(p.i, p.j), on_j = share<TypeParam, double, 3>(p.j, p.i);
  double kinetic = 0;
  for (int d = 0; d < 3; ++d) kinetic += p.i.m * p.i.v[d] * on_i.a[d] + p.j.m * p.j.v[d] * on_j.a[d];
  const double heat = p.i.m * on_i.du + p.j.m * on_j.du;
  EXPECT_GT(heat, 0);
  EXPECT_NEAR(kinetic + heat, 0, 1e-14 * heat);
}

TYPED_TEST(Dissipation, VanishesForRecedingParticlesAndForParticlesAtRest) {
  TwoParticles<double, 3> p;
  p.i.v[0] = 2, p.j.v[0] = 1;
  EXPECT_EQ((share<TypeParam, double, 3>(p.i, p.j).a[0]), 0);
  EXPECT_EQ((share<TypeParam, double, 3>(p.i, p.j).du), 0);
  p.i.v = p.j.v;
  EXPECT_EQ((share<TypeParam, double, 3>(p.i, p.j).a[0]), 0);
}

/// The energy form of eq 7: heat takes up what the force takes from the motion, for a pair that approaches and one that
/// recedes.
TEST(EnergyBudget, OfThePressureForceAndItsWorkIsClosed) {
  for (const double towards : {-1.0, 1.0}) {
    TwoParticles<double, 3> p;
    p.i.v[0] *= towards, p.j.v[0] *= towards;
    const TwoParticles<double, 3>& q = p;
    const auto force_i = share<PressureGradientTsph, double, 3>(q.i, q.j),
               force_j = share<PressureGradientTsph, double, 3>(q.j, q.i);
    double kinetic = 0;
    for (int d = 0; d < 3; ++d) kinetic += q.i.m * q.i.v[d] * force_i.a[d] + q.j.m * q.j.v[d] * force_j.a[d];
    const double heat = q.i.m * share<PressureWorkTsph, double, 3>(q.i, q.j).du +
                        q.j.m * share<PressureWorkTsph, double, 3>(q.j, q.i).du;
    EXPECT_GT(towards * heat, 0) << "compression heats, expansion cools";
    EXPECT_NEAR(kinetic + heat, 0, 1e-14 * std::abs(heat));
  }
}

/// Entropy dissipation moves heat from the particle with more of it to the other.
TEST(EnergyBudget, OfEntropyDissipationIsClosed) {
  const TwoParticles<double, 3> p;  // u_i = 1.8, u_j = 5.4
  const double to_i = p.i.m * share<EntropyDissipation<>, double, 3>(p.i, p.j).du,
               to_j = p.j.m * share<EntropyDissipation<>, double, 3>(p.j, p.i).du;
  EXPECT_GT(to_i, 0);
  EXPECT_NEAR(to_i + to_j, 0, 1e-14 * to_i);
}

}  // namespace
}  // namespace sphk::test
