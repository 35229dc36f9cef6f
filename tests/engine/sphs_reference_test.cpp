// SPDX-License-Identifier: BSD-3-Clause

// The explicit sums against what follows from the equations alone: exact fits, conservation, Galilean invariance and
// two particles by hand. A sum of N terms in double loses about 1e-16 sqrt(N) of the sum of their absolute values;
// 1e-13 of it leaves two decades.
#include "tests/engine/sphs_reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/engine/array3.hpp"

namespace sphk::test {
namespace {

constexpr double rounding = 1e-13;

SimulationSettings settings_for(int dimension) {
  SimulationSettings s;
  s.kernel = "cs";
  s.neighbours = dimension == 1 ? 10 : dimension == 2 ? 28 : 60;
  s.gamma = 1.4;
  return s;
}

ParticleSet gas_in(int dimension) {
  const Array3 counts = dimension == 1 ? Array3{40, 1, 1} : dimension == 2 ? Array3{12, 10, 1} : Array3{6, 6, 5};
  return shaken_lattice(dimension, counts, 0.3, true, 11);
}

void expect_zero(const Sum& sum, const char* what) {
  EXPECT_NEAR(sum.value, 0, rounding * sum.magnitude) << what;
}

void expect_zero(const Budget& budget) {
  expect_zero(budget.mass, "mass");
  for (const Sum& component : budget.momentum) expect_zero(component, "momentum");
  expect_zero(budget.energy, "energy");
}

/// Velocities v_a = b_a + G_a . x + x . H_a x, H symmetric, on uniformly random particles of an open box.
struct QuadraticFlow {
  double b[3], G[3][3], H[3][3][3];
  ParticleSet gas;

  QuadraticFlow(int D, int size, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int a = 0; a < 3; ++a) {
      b[a] = unit(engine);
      for (int k = 0; k < 3; ++k) {
        G[a][k] = unit(engine) - (a == k ? 1 : 0);
        for (int l = 0; l <= k; ++l) H[a][k][l] = H[a][l][k] = unit(engine);
      }
    }
    gas.dimension = D;
    for (int i = 0; i < size; ++i) {
      Array3 x{}, v{};
      for (int d = 0; d < D; ++d) x[d] = 0.5 * (1 + unit(engine));
      for (int a = 0; a < D; ++a) v[a] = velocity(x, a);
      gas.x.push_back(x), gas.v.push_back(v);
      gas.m.push_back(1 + 0.3 * unit(engine));
      gas.u.push_back(1 + 0.5 * unit(engine));
    }
  }
  double velocity(const Array3& x, int a) const {
    double value = b[a];
    for (int k = 0; k < gas.dimension; ++k) {
      value += G[a][k] * x[k];
      for (int l = 0; l < gas.dimension; ++l) value += H[a][k][l] * x[k] * x[l];
    }
    return value;
  }
  double slope(const Array3& x, int a, int along) const {
    if (a >= gas.dimension || along >= gas.dimension) return 0;
    double value = G[a][along];
    for (int l = 0; l < gas.dimension; ++l) value += 2 * H[a][along][l] * x[l];
    return value;
  }
};

class SphsReferenceIn : public testing::TestWithParam<int> {
 protected:
  const int D = GetParam();
  const SimulationSettings settings = settings_for(D);
  const ParticleSet gas = gas_in(D);
};

// The QR loses sqrt(condition), the condition number of its rows, of the digits of the largest coefficient; those of a
// flow with |G|, |H| <= 2 are below 10 for h < 1. dv/dx is a coefficient over h, a second derivative over h^2.
TEST_P(SphsReferenceIn, TheFitReproducesAQuadraticFlow) {
  const QuadraticFlow flow(D, D == 1 ? 60 : 250, 3);
  const SphsReference sphs(flow.gas, settings);
  const double n_s = 0.05, epsilon = 2.2e-16;
  for (std::size_t i = 0; i < flow.gas.size(); ++i) {
    const Array3& x = flow.gas.x[i];
    const double h = sphs.gas.h[i], error = 100 * epsilon * std::sqrt(sphs.condition[i]);
    const auto d = [&](int a, int along) { return flow.slope(x, a, along); };
    const double div = d(0, 0) + d(1, 1) + d(2, 2), size = std::abs(div);
    const Array3 curl{d(2, 1) - d(1, 2), d(0, 2) - d(2, 0), d(1, 0) - d(0, 1)};
    Array3 grad_div{};
    for (int k = 0; k < D; ++k)
      for (int a = 0; a < D; ++a) grad_div[k] += 2 * flow.H[a][a][k];
    ASSERT_LT(sphs.condition[i], 1e12) << i;
    ASSERT_NEAR(sphs.div_v[i] * h, div * h, error) << i;
    for (int k = 0; k < 3; ++k) {
      ASSERT_NEAR(sphs.curl_v[i][k] * h, curl[k] * h, error) << i;
      ASSERT_NEAR(sphs.grad_div_v[i][k] * h * h, grad_div[k] * h * h, error) << i;
    }
    const double bend = h * h * std::sqrt(dot(grad_div, grad_div));  // S12 eq 21 and 32
    const double alpha = div < 0 ? bend / (bend + h * size + n_s * sphs.gas.c[i]) : 0;
    ASSERT_NEAR(sphs.alpha_loc[i], alpha, 1e-9) << i;
    const double limit = size / (size + std::sqrt(dot(curl, curl)) + 1e-4 * sphs.gas.c[i] / h);
    ASSERT_NEAR(sphs.balsara[i], limit, 1e-7) << i;
    ASSERT_EQ(sphs.alpha[i], sphs.alpha_loc[i] * sphs.balsara[i]) << i;
  }
}

TEST_P(SphsReferenceIn, DissipationConservesAndHeats) {
  const std::vector<double> full(gas.size(), 1);
  const SphsReference sphs(gas, settings, {.balsara = BalsaraOn::nothing, .alpha = full});
  expect_zero(sphs.budget(sphs.viscosity));
  expect_zero(sphs.budget(sphs.entropy));
  for (const double heating : sphs.viscosity.du) EXPECT_GE(heating, 0);
}

TEST_P(SphsReferenceIn, TheSwitchOfUnevenGasIsOnAndEveryTermActs) {
  const SphsReference sphs(gas, settings);
  EXPECT_GT(*std::max_element(sphs.alpha.begin(), sphs.alpha.end()), 0.01);
  for (const auto* rates : {&sphs.viscosity.du, &sphs.entropy.du, &sphs.mass.du, &sphs.mass.dm})
    EXPECT_GT(*std::max_element(rates->begin(), rates->end()), 0);
}

TEST_P(SphsReferenceIn, EveryFormOfMassExchangeConservesAtFixedDensity) {
  for (const MassForm form : {MassForm::s12, MassForm::appendix_e, MassForm::donor}) {
    const SphsReference sphs(gas, settings, {.mass = form, .pay_for_density = false});
    expect_zero(sphs.budget(sphs.mass));
    const Sum whole = sphs.energy_of_exchange();  // the density does change
    EXPECT_GT(std::abs(whole.value), 1e4 * rounding * whole.magnitude);
  }
}

TEST_P(SphsReferenceIn, WithTheDensityPaidForTheWholeEnergyIsConserved) {
  for (const MassForm form : {MassForm::s12, MassForm::appendix_e, MassForm::donor}) {
    const SphsReference sphs(gas, settings, {.mass = form});
    const Budget budget = sphs.budget(sphs.mass);
    expect_zero(budget.mass, "mass");
    for (const Sum& component : budget.momentum) expect_zero(component, "momentum");
    expect_zero(sphs.energy_of_exchange(), "energy");
  }
}

TEST_P(SphsReferenceIn, PressureForcesConserveWhatTheyPromise) {
  const auto of = [&](MomentumForm form) {
    const SphsReference sphs(gas, settings, {.momentum = form});
    return sphs.budget(sphs.pressure);
  };
  for (const MomentumForm form : {MomentumForm::tsph, MomentumForm::conservative})
    for (const Sum& component : of(form).momentum) expect_zero(component, "momentum");
  expect_zero(of(MomentumForm::conservative).energy, "energy");
  const Sum morris = of(MomentumForm::morris).momentum[0];
  EXPECT_GT(std::abs(morris.value), 1e-3 * morris.magnitude);
}

/// sum m (v^2/2 + A rho^(gamma-1)/(gamma-1)) after all rates of `sphs` have acted for dt, density found anew.
Sum energy_after(double dt, ParticleSet gas, const SimulationSettings& settings, const SphsReference& sphs) {
  for (std::size_t i = 0; i < gas.size(); ++i) {
    add(gas.x[i], dt, gas.v[i]);
    add(gas.v[i], dt, sphs.a[i]);
    gas.m[i] += dt * sphs.dm_dt[i];
  }
  const BruteForce moved(gas, settings);
  Sum energy;
  for (std::size_t i = 0; i < gas.size(); ++i) {
    const double A = sphs.A[i] + dt * sphs.dA_dt[i];
    energy.add(gas.m[i] * 0.5 * dot(gas.v[i], gas.v[i]));
    energy.add(gas.m[i] * A * std::pow(moved.rho[i], settings.gamma - 1) / (settings.gamma - 1));
  }
  return energy;
}

// A central difference over 2 dt: with rates of up to about 100 per unit time it is cut off at (100 dt)^2 / 6 = 2e-7 of
// the parts' rates, and the energy, known to 1e-15, adds 1e-10. Unpaid, the energy drifts by 1e-3 of them.
TEST_P(SphsReferenceIn, TheEnergyOfTheMovedGasStays) {
  const double dt = 1e-5;
  const auto drift = [&](const SphsReference& sphs) {
    return (energy_after(dt, gas, settings, sphs).value - energy_after(-dt, gas, settings, sphs).value) / (2 * dt);
  };
  const SphsReference paid(gas, settings, {.momentum = MomentumForm::conservative});
  const SphsReference unpaid(gas, settings, {.momentum = MomentumForm::conservative, .pay_for_density = false});
  const double tolerance = 2e-7 * paid.budget(paid.pressure).energy.magnitude, lost = unpaid.energy_of_exchange().value;
  EXPECT_NEAR(drift(paid), 0, tolerance);
  EXPECT_NEAR(drift(unpaid), lost, tolerance);
  EXPECT_GT(std::abs(lost), 1000 * tolerance);
}

/// Rates of the mass exchange with the gas at rest and with all of it moving at V.
struct Boosted {
  Array3 V;
  TermRates rest, moving;
};

Boosted boosted(ParticleSet gas, const SimulationSettings& settings, MassForm form) {
  Boosted out{{3, gas.dimension > 1 ? -2.0 : 0.0, gas.dimension > 2 ? 5.0 : 0.0}, {}, {}};
  out.rest = SphsReference(gas, settings, {.mass = form}).mass;
  for (Array3& v : gas.v) add(v, 1, out.V);
  out.moving = SphsReference(gas, settings, {.mass = form}).mass;
  return out;
}

// With F_ij from i's side and dm = sum F: S12 eq 39 adds -(dm/m) V and eq 40 (dm/m)(v.V + V^2/2); eq E6 adds (dm/m) V
// and eq E8 sum F/m (v_j.V + V^2/2) = dv.V + (dm/m) V^2/2. The donor form holds differences only and adds nothing.
// alpha follows from fits whose rounding grows with V^2 and with their condition: 1e-10 of the rates.
TEST_P(SphsReferenceIn, AMovingObserverSeesTheDonorFormUnchangedAndTheOthersChanged) {
  for (const MassForm form : {MassForm::s12, MassForm::appendix_e, MassForm::donor}) {
    const auto [V, rest, moving] = boosted(gas, settings, form);
    const double V2 = dot(V, V), most = *std::max_element(rest.dm.begin(), rest.dm.end());
    const double tolerance = 1e-10 * V2 * most / gas.m[0];
    ASSERT_GT(most, 0);  // so that there is something to see
    for (std::size_t i = 0; i < gas.size(); ++i) {
      const double gain = rest.dm[i] / gas.m[i];
      const double of_v = form == MassForm::s12 ? -gain : form == MassForm::appendix_e ? gain : 0;
      const double of_u = form == MassForm::s12          ? gain * (dot(gas.v[i], V) + 0.5 * V2)
                          : form == MassForm::appendix_e ? dot(rest.dv[i], V) + 0.5 * gain * V2
                                                         : 0;
      ASSERT_NEAR(moving.dm[i], rest.dm[i], tolerance * gas.m[i]) << i;
      for (int d = 0; d < 3; ++d) ASSERT_NEAR(moving.dv[i][d] - rest.dv[i][d], of_v * V[d], tolerance) << i;
      ASSERT_NEAR(moving.du[i] - rest.du[i], of_u, tolerance) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, SphsReferenceIn, testing::Values(1, 2, 3),
                         [](const auto& info) { return std::to_string(info.param) + "D"; });

/// Two particles in 1D, 1/2 apart, the first runs at the second. For the cubic spline N = 4/3, w(0) = 1, w(1/2) = 1/4,
/// w'(1/2) = -3/2, so 2 h n = 2 (4/3)(1 + 1/4) = 10/3 gives h = 1, W(0) = 4/3, W = 1/3, W' = -2. Then rho = 2, 3; with
/// gamma = 2 P = rho u = 4, 24 and c = sqrt(2 u) = 2, 4; w_12 = -1, v_sig = 9, rho_12 = 5/2, L = 20/28 = 5/7.
struct TwoParticles : testing::Test {
  ParticleSet gas;
  SimulationSettings settings{.kernel = "cs"};
  TwoParticles() {
    gas.dimension = 1;
    gas.x = {{0, 0, 0}, {0.5, 0, 0}};
    gas.v = {{1, 0, 0}, {0, 0, 0}};
    gas.m = {1, 2};
    gas.u = {2, 8};
    settings.gamma = 2;
    settings.neighbours = 10.0 / 3;
  }
  SphsReference rates(SphsOptions options) const {
    options.alpha = {1, 1};
    options.balsara = BalsaraOn::nothing;
    return {gas, settings, options};
  }
};

void expect_pair(const std::vector<double>& got, double first, double second) {
  EXPECT_NEAR(got[0], first, 1e-12 * (1 + std::abs(first)));
  EXPECT_NEAR(got[1], second, 1e-12 * (1 + std::abs(second)));
}

void expect_pair(const std::vector<Array3>& got, double first, double second) {
  expect_pair({got[0][0], got[1][0]}, first, second);
}

TEST_F(TwoParticles, PressureViscosityAndEntropyByHand) {
  const SphsReference sphs = rates({});
  expect_pair(sphs.gas.h, 1, 1);
  expect_pair(sphs.gas.rho, 2, 3);
  expect_pair(sphs.v_max, 9, 9);
  expect_pair(sphs.pressure.dv, -2 * 28 / 6.0 * 2, 1 * 28 / 6.0 * 2);
  expect_pair(rates({.momentum = MomentumForm::morris}).pressure.dv, -2 * 20 / 6.0 * 2, -1 * 20 / 6.0 * 2);
  expect_pair(sphs.viscosity.dv, -2 * 1.8 * 2, 1 * 1.8 * 2);  // Pi = 9 / (2 5/2) = 1.8
  expect_pair(sphs.viscosity.du, 0.5 * 2 * 1.8 * 2, 0.5 * 1 * 1.8 * 2);
  const double flux = 9 * 5 / 7.0 / 2.5 * 6 * 2;  // v_sig L / rho_12 (u_2 - u_1) |W'|
  expect_pair(sphs.entropy.du, 2 * flux, -1 * flux);
  expect_pair(rates({.alpha_v = 0.5}).viscosity.du, 0.9 * 2, 0.9);
  expect_pair(rates({.alpha_A = 0.5}).entropy.du, flux, -0.5 * flux);
}

// F = m_12/rho_12 v_sig L (m_2 - m_1) |W'| = 0.6 9 (5/7) 2 flows to the first; the densities gain F (4/3 - 1/3) and
// lose as much; P/rho^2 = 1, 8/3.
TEST_F(TwoParticles, MassExchangeByHand) {
  const double F = 54.0 / 7;
  const auto mass = [&](MassForm form, bool pay) { return rates({.mass = form, .pay_for_density = pay}).mass; };
  expect_pair(mass(MassForm::donor, false).dm, F, -F);
  expect_pair(mass(MassForm::donor, false).dv, F * (0 - 1), 0);
  expect_pair(mass(MassForm::donor, false).du, F * (8 - 2 + 0.5), 0);
  expect_pair(mass(MassForm::donor, true).du, F * (8 - 2 + 0.5 - 1), F * 8 / 3);
  expect_pair(mass(MassForm::s12, false).dv, -F * 1, 0);
  expect_pair(mass(MassForm::s12, false).du, F * (0.5 - 2), -F / 2 * (0 - 8));
  expect_pair(mass(MassForm::appendix_e, false).dv, 0, -F / 2 * 1);
  expect_pair(mass(MassForm::appendix_e, false).du, F * 8, -F / 2 * (0.5 + 2));
  expect_pair(rates({.alpha_m = 0.5}).mass.dm, F / 2, -F / 2);
}

}  // namespace
}  // namespace sphk::test
