// SPDX-License-Identifier: BSD-3-Clause

// SPHS's rates against the explicit sums of SphsReference. Both are in double: tolerances as in right_hand_side.cpp,
// times the condition number of the fits (some hundred) for what is fitted.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "src/schemes/registry.hpp"
#include "tests/engine/compare_fields.hpp"
#include "tests/engine/sphs_reference.hpp"

namespace sphk::test {
namespace {

enum Form { donor, donor_unpaid, flux, particle };

struct Case {
  std::string name, scheme, kernel;
  int dimension;
  Array3 counts;
  double neighbours;
  bool periodic, equal_masses;
  int form = donor;  ///< the place of a word of dissipation.mass_form
};

SphsOptions options_of(const Case& c) {
  SphsOptions options;
  if (c.scheme == "sphs-morris") options.momentum = MomentumForm::morris;
  if (c.scheme == "sphs-conservative") options.momentum = MomentumForm::conservative;
  if (c.form == flux) options.mass = MassForm::appendix_e;
  if (c.form == particle) options.mass = MassForm::s12;
  options.pay_for_density = c.form == donor;
  options.alpha_v = 0.7, options.alpha_A = 1.3, options.alpha_m = 0.9;
  return options;
}

class SphsRightHandSide : public testing::TestWithParam<Case> {};

TEST_P(SphsRightHandSide, EqualsTheExplicitSums) {
  const Case& c = GetParam();
  ParticleSet gas = shaken_lattice(c.dimension, c.counts, 0.3, c.periodic, 11);
  if (c.equal_masses) gas.m.assign(gas.size(), gas.m[0]);
  const SphsOptions options = options_of(c);
  SimulationSettings s;
  s.scheme = c.scheme, s.kernel = c.kernel, s.neighbours = c.neighbours, s.precision = "double";
  s.numbers = {{"viscosity.alpha", options.alpha_v}, {"dissipation.entropy", options.alpha_A}};
  if (c.scheme != "sphs-rt")
    s.numbers.set("dissipation.mass", options.alpha_m), s.numbers.set("dissipation.mass_form", c.form);
  s.all_terms = true;
  const SphsReference wanted(gas, s, options);
  const auto got = make_simulation(gas, s)->rates(false);
  const double table = c.kernel == "hoct4" ? 1 : 1e4;  // others run through the table
  expect_near(named(got, "Density"), wanted.gas.rho, 1e-12 * table, "rho");
  expect_near(named(got, "VelocityDivergence"), wanted.div_v, 1e-10 * table, "div v");
  expect_near(named(got, "VelocityCurl"), flat(wanted.curl_v), 1e-10 * table, "curl v");
  expect_near(named(got, "GradVelocityDivergence"), flat(wanted.grad_div_v), 1e-10 * table, "grad div v");
  expect_near(named(got, "AlphaLoc"), wanted.alpha_loc, 1e-10 * table, "alpha_loc");
  expect_near(named(got, "Acceleration"), flat(wanted.a), 1e-10 * table, "a");
  expect_near(named(got, "EntropyRate"), wanted.dA_dt, 1e-10 * table, "dA/dt");
  if (!c.equal_masses) expect_near(named(got, "MassRate"), wanted.dm_dt, 1e-10 * table, "dm/dt");
}

INSTANTIATE_TEST_SUITE_P(
    Cases, SphsRightHandSide,
    testing::Values(Case{"equal_masses_3d", "sphs", "hoct4", 3, {9, 9, 9}, 128, true, true},
                    Case{"donor_3d", "sphs", "hoct4", 3, {9, 8, 9}, 128, true, false},
                    Case{"donor_3d_open", "sphs", "hoct4", 3, {7, 8, 9}, 96, false, false},
                    Case{"flux_3d_slab", "sphs", "hoct4", 3, {9, 9, 2}, 128, true, false, flux},
                    Case{"donor_3d_slab_of_one_layer", "sphs", "hoct4", 3, {9, 9, 1}, 442, true, false},
                    Case{"particle_3d_table", "sphs", "ct", 3, {9, 8, 9}, 100, true, false, particle},
                    Case{"donor_unpaid_2d", "sphs", "hoct4", 2, {14, 12, 1}, 40, true, false, donor_unpaid},
                    Case{"equal_masses_2d_table", "sphs", "wc4", 2, {14, 12, 1}, 36, false, true},
                    Case{"donor_1d", "sphs", "wc2", 1, {40, 1, 1}, 8, true, false},
                    Case{"equal_masses_1d", "sphs", "m6", 1, {40, 1, 1}, 9, false, true},
                    Case{"morris_3d", "sphs-morris", "hoct4", 3, {9, 8, 9}, 128, true, false},
                    Case{"conservative_3d", "sphs-conservative", "hoct4", 3, {9, 8, 9}, 128, true, false},
                    Case{"conservative_2d", "sphs-conservative", "wc2", 2, {14, 12, 1}, 40, true, false}),
    [](const auto& info) { return info.param.name; });

/// Where u is integrated, A changes by what the work of eq 7 is more than the adiabatic one, beside dissipation; and
/// what exchanged mass does to rho costs nothing.
TEST(SphsEnergyForm, EntropyRateEqualsTheExplicitSums) {
  const ParticleSet gas = shaken_lattice(3, {9, 8, 9}, 0.3, true, 11);
  SimulationSettings s;
  s.scheme = "sphs", s.kernel = "hoct4", s.neighbours = 128, s.precision = "double", s.energy = "energy";
  SphsOptions options;
  options.pay_for_density = false;
  const SphsReference wanted(gas, s, options);
  std::vector<double> rate = wanted.dA_dt;
  for (std::size_t i = 0; i < gas.size(); ++i) {
    double convergence = 0;  // sum_j m_j/rho_j v_ij . grad Wbar
    for (const auto& pair : wanted.gas.pairs(static_cast<int>(i)))
      for (int d = 0; d < 3; ++d)
        convergence += gas.m[pair.j] / wanted.gas.rho[pair.j] * (gas.v[i][d] - gas.v[pair.j][d]) * pair.e[d] * pair.dW;
    const double P_rho = wanted.gas.P[i] / wanted.gas.rho[i];
    rate[i] += (s.gamma - 1) * std::pow(wanted.gas.rho[i], 1 - s.gamma) * P_rho * (convergence + wanted.div_v[i]);
  }
  const auto got = make_simulation(gas, s)->rates(false);
  expect_near(named(got, "EntropyRate"), rate, 1e-10, "dA/dt");
  expect_near(named(got, "Acceleration"), flat(wanted.a), 1e-10, "a");
}

/// P_i = [sum_j m_j A_j^(1/gamma) Wbar]^gamma (S12 eq 20), the pair of i with itself included, in S12 eq 7. The A_j are
/// those with which u_i = P_i/((gamma-1) rho_i), rho_i = (P_i/A_i)^(1/gamma), is what the gas was given: snapshots tell
/// the pressure that acts.
TEST(SphsRt, PressureAndForceEqualTheExplicitSums) {
  ParticleSet gas = shaken_lattice(3, {9, 8, 9}, 0.3, true, 11);
  gas.m.assign(gas.size(), gas.m[0]);
  SimulationSettings s;
  s.scheme = "sphs-rt", s.kernel = "hoct4", s.neighbours = 128, s.precision = "double",
  s.numbers.set("switch.alpha", 0);
  BruteForce wanted(gas, s);
  std::vector<double> root;
  std::vector<std::vector<BruteForce::Pair>> pairs;
  for (std::size_t j = 0; j < gas.size(); ++j) {
    root.push_back(std::pow(wanted.P[j] / std::pow(wanted.rho[j], s.gamma), 1 / s.gamma));
    pairs.push_back(wanted.pairs(static_cast<int>(j)));
  }
  for (int round = 0; round < 60; ++round) {
    for (std::size_t i = 0; i < gas.size(); ++i) {
      double sum = 0;
      for (const auto& pair : pairs[i]) sum += gas.m[pair.j] * root[pair.j] * pair.W;
      wanted.P[i] = std::pow(sum, s.gamma);
    }
    if (round == 59) break;
    for (std::size_t i = 0; i < gas.size(); ++i) {
      const double u = std::pow(wanted.P[i], 1 - 1 / s.gamma) * root[i] / (s.gamma - 1);
      root[i] *= std::pow(gas.u[i] / u, 1 / s.gamma);
    }
  }
  std::vector<double> a;
  for (std::size_t i = 0; i < gas.size(); ++i) {
    Array3 sum{};
    for (const auto& pair : pairs[i])
      for (int d = 0; d < 3; ++d)
        sum[d] += wanted.pressure_force(MomentumForm::tsph, static_cast<int>(i), pair) * pair.e[d];
    a.insert(a.end(), sum.begin(), sum.end());
  }
  const auto simulation = make_simulation(gas, s);
  const Snapshot snapshot = simulation->snapshot();
  expect_near(snapshot.field("Pressures").values, wanted.P, 1e-10, "P");
  expect_near(snapshot.field("InternalEnergies").values, gas.u, 1e-10, "u");
  double thermal = 0;
  for (std::size_t i = 0; i < gas.size(); ++i) thermal += gas.m[i] * gas.u[i];
  EXPECT_NEAR(simulation->totals().thermal, thermal, 1e-10 * thermal);
  const auto got = simulation->rates(false);
  expect_near(named(got, "Acceleration"), a, 1e-10, "a");
  for (const double rate : named(got, "EntropyRate")) ASSERT_EQ(rate, 0) << "nothing dissipates";
}

/// v = a + B x + x C x on random places: div v = tr B + sum_k 2 (C^c_kc) x, and its gradient, are exact.
TEST(SphsGradients, OfAQuadraticFlowThroughRandomPlacesAreExact) {
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> place(0, 1);
  ParticleSet gas;
  gas.box = {{0, 0, 0}, {1, 1, 1}, {false, false, false}};
  std::vector<double> div;
  for (int i = 0; i < 800; ++i) {
    const Array3 x{place(engine), place(engine), place(engine)};
    gas.x.push_back(x);
    gas.v.push_back({1 + 2 * x[0] - x[1] + 0.5 * x[0] * x[0] + x[0] * x[2], x[2] * x[2] - 3 * x[1] * x[1] + x[0],
                     4 * x[2] + x[0] * x[1] - x[2] * x[1]});
    div.push_back(2 + x[0] + x[2] - 6 * x[1] + 4 - x[1]);
    gas.m.push_back(0.5 + place(engine));
    gas.u.push_back(1);
  }
  SimulationSettings s;
  s.scheme = "sphs", s.kernel = "hoct4", s.neighbours = 128, s.precision = "double";
  const auto got = make_simulation(gas, s)->rates(false);
  expect_near(named(got, "VelocityDivergence"), div, 1e-9, "div v");
  const auto& grad = named(got, "GradVelocityDivergence");
  const double exact[] = {1, -7, 1};
  for (std::size_t k = 0; k < grad.size(); ++k) ASSERT_NEAR(grad[k], exact[k % 3], 1e-7);
}

/// All neighbours in a plane, or on a line: no second-order fit in 3D, and no linear one either; the SPH estimate
/// serves, and is reported.
TEST(SphsGradients, OfDegenerateNeighboursFallBackAndAreCounted) {
  for (const Array3 counts : {Array3{12, 12, 1}, Array3{60, 1, 1}}) {
    ParticleSet gas = shaken_lattice(2, counts, 0.2, false, 5);
    gas.dimension = 3;
    gas.box.size[2] = 1;
    SimulationSettings s;
    s.scheme = "sphs", s.kernel = "hoct4", s.neighbours = 40, s.precision = "double";
    const auto simulation = make_simulation(gas, s);
    const auto rates = simulation->rates(false);
    for (const char* name : {"VelocityDivergence", "VelocityCurl", "Acceleration", "EntropyRate"})
      for (const double value : named(rates, name)) ASSERT_TRUE(std::isfinite(value)) << name;
    ASSERT_FALSE(simulation->warnings().empty());
    bool reported = false;
    for (const std::string& warning : simulation->warnings())
      reported |= warning.find("gave way to the SPH estimate") != std::string::npos;
    EXPECT_TRUE(reported);
  }
}

}  // namespace
}  // namespace sphk::test
