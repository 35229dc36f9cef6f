// SPDX-License-Identifier: BSD-3-Clause

// What a run does not need is neither computed nor allocated, and leaving it out changes no result.
#include <gtest/gtest.h>

#include <cmath>

#include "src/schemes/compiled_rows.hpp"
#include "src/schemes/registry.hpp"
#include "tests/compiled_schemes.hpp"
#include "tests/engine/brute_force.hpp"

namespace sphk::test {
namespace {

struct Case {
  std::string name, scheme, kernel;
  double neighbours;
  Given numbers;
  std::vector<std::string> gone;  ///< fields that the leaner recipe has no columns for
  double tolerance = 1e-12;       ///< of the state after some steps, relative: other sums in another order
};

class LeavingOut : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    if (!is_compiled(GetParam().scheme)) GTEST_SKIP();
  }
  SimulationSettings settings(bool all_terms) const {
    const Case& c = GetParam();
    SimulationSettings s{.scheme = c.scheme, .kernel = c.kernel, .precision = "double", .neighbours = c.neighbours};
    s.steps = global_steps;
    s.numbers = c.numbers;
    s.all_terms = all_terms;
    return s;
  }
  static ParticleSet gas() {
    ParticleSet gas = shaken_lattice(3, {8, 8, 8}, 0.3, true, 3);
    gas.m.assign(gas.size(), gas.m[0]);
    return gas;
  }
};

TEST_P(LeavingOut, ChangesNoResult) {
  Snapshot ends[2];
  for (const bool all : {false, true}) {
    const auto run = make_simulation(gas(), settings(all));
    for (int step = 0; step < 5; ++step) run->step(1e9);
    ends[all] = run->snapshot();
  }
  for (const char* name : {"Coordinates", "Velocities", "InternalEnergies", "Densities"}) {
    const auto &lean = ends[0].field(name).values, &all = ends[1].field(name).values;
    double scale = 0;
    for (const double value : all) scale = std::max(scale, std::abs(value));
    for (std::size_t k = 0; k < all.size(); ++k) ASSERT_NEAR(lean[k], all[k], GetParam().tolerance * scale) << name;
  }
}

TEST_P(LeavingOut, TakesFewerOperationsAndColumnsAndSaysSo) {
  const SchemeDescription lean = describe(settings(false), gas()), all = describe(settings(true), gas());
  EXPECT_LT(lean.flops_per_pair, all.flops_per_pair);
  EXPECT_LE(lean.bytes_per_particle, all.bytes_per_particle);
  if (!GetParam().gone.empty()) EXPECT_LT(lean.bytes_per_particle, all.bytes_per_particle);
  for (const std::string& field : GetParam().gone) {
    EXPECT_NE(std::ranges::find(all.fields, field), all.fields.end()) << field;
    EXPECT_EQ(std::ranges::find(lean.fields, field), lean.fields.end()) << field;
  }
  EXPECT_GT(lean.left_out.size(), all.left_out.size());
}

const std::vector<std::string> balsara{"BalsaraFactors", "VelocityCurl"};
const std::vector<std::string> exchange{"MassRate", "MassMomentumRate", "MassEnergyRate", "MassDensityRate",
                                        "HalfStepMasses"};
INSTANTIATE_TEST_SUITE_P(
    Idle, LeavingOut,
    testing::Values(
        Case{"gadget2_inviscid", "gadget2", "cs", 48, {{"viscosity.alpha", 0}}, balsara},
        Case{"gadget2_no_balsara", "gadget2", "cs", 48, {{"viscosity.balsara", 0}}, balsara},
        Case{"sph_inviscid", "sph", "cs", 48, {{"viscosity.alpha", 0}, {"viscosity.beta", 0}}, balsara},
        Case{"sph_no_balsara", "sph", "cs", 48, {{"viscosity.balsara", 0}}, balsara},
        Case{"tsph_no_balsara", "tsph", "hoct4", 100, {{"viscosity.balsara", 0}}, balsara},
        Case{"osph_inviscid", "osph", "hoct4", 100, {{"viscosity.alpha", 0}, {"viscosity.beta", 0}}, balsara},
        Case{"sphs_equal_masses", "sphs", "hoct4", 100, {}, exchange},
        Case{"sphs_inviscid", "sphs", "hoct4", 100, {{"viscosity.alpha", 0}}, {"ViscosityAlpha"}},
        Case{"sphs_isentropic", "sphs", "hoct4", 100, {{"dissipation.entropy", 0}}, {"DissipationAlpha"}},
        // Here div v is the SPH estimate in place of the fit: it predicts h, whose search ends within 3e-4 of its root,
        // carried over to second order.
        Case{"sphs_one_alpha",
             "sphs",
             "hoct4",
             100,
             {{"switch.alpha", 0.7}},
             {"GradVelocityDivergence", "VelocityCurl", "Alpha", "ViscosityAlpha", "DissipationAlpha"},
             1e-6},
        Case{"sphs_ideal",
             "sphs",
             "hoct4",
             100,
             {{"viscosity.alpha", 0}, {"dissipation.entropy", 0}},
             {"GradVelocityDivergence", "VelocityCurl", "Alpha", "ViscosityAlpha", "DissipationAlpha"},
             1e-6},
        Case{"osph_coherent_inviscid",
             "osph-coherent",
             "wc2",
             60,
             {{"viscosity.alpha", 0}, {"viscosity.beta", 0}},
             balsara},
        Case{"v10_inviscid_no_conductivity",
             "v10",
             "wc4",
             80,
             {{"viscosity.alpha", 0}, {"conductivity.alpha", 0}},
             balsara},
        Case{"conservative_equal_masses", "sphs-conservative", "hoct4", 100, {}, exchange}),
    [](const auto& info) { return info.param.name; });

/// Ways in which terms of a scheme can be idle, of the keys that it has.
std::vector<Given> idle_numbers(const std::string& scheme) {
  std::vector<Given> ways;
  for (const std::vector<const char*>& zero :
       {std::vector{"viscosity.alpha", "viscosity.beta"},
        {"conductivity.alpha"},
        {"dissipation.entropy"},
        {"dissipation.mass"},
        {"viscosity.alpha", "viscosity.beta", "conductivity.alpha", "dissipation.entropy"}}) {
    Given numbers;
    for (const Number* number : scheme_entry(scheme).numbers)
      if (std::ranges::find(zero, std::string(number->key)) != zero.end()) numbers.set(number->key, 0);
    if (!numbers.values().empty()) ways.push_back(numbers);
  }
  return ways;
}

/// In 1D nothing is worth a loop of its own. Variants of SPHS are there to be compared with it: they leave out the
/// exchange of mass and no more.
bool leaves_all_out(const std::string& scheme) {
  return !scheme.starts_with("sphs-");
}

TEST(LeavingOutOfAll, NothingIdleIsComputedWithTheUsualKernelsOf2DAnd3D) {
  int tried = 0;
  for (const Instantiation& row : compiled_rows()) {
    if (!row.complete || row.kernel || row.dimension == 1 || !leaves_all_out(row.scheme->name) || row.scheme->hidden)
      continue;
    ParticleSet gas = shaken_lattice(row.dimension, {8, 8, 8}, 0.3, true, 3);
    gas.m.assign(gas.size(), gas.m[0]);
    for (const Given& numbers : idle_numbers(row.scheme->name)) {
      SimulationSettings settings{.scheme = row.scheme->name, .precision = row.precision, .energy = row.energy};
      settings.numbers = numbers;
      const SchemeDescription description = describe(settings, gas);
      for (const std::string& term : description.idle)
        ADD_FAILURE() << row.scheme->name << " " << row.energy << " " << row.dimension << "D " << row.precision << ": "
                      << term << " where " << numbers.values()[0].first << " = 0";
      ++tried;
    }
  }
  EXPECT_GT(tried, 0);
}

}  // namespace
}  // namespace sphk::test
