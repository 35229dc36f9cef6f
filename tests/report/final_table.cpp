// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/final_table.hpp"

#include <gtest/gtest.h>

namespace sphk {
namespace {

TEST(FinalTable, ShowsPhasesRatesConservationAndErrors) {
  RunRecord r;
  r.wall_seconds = 2;
  r.steps = 10;
  r.costs.updates = 1000000;
  r.costs.flops = 2e10;
  r.costs.phases = {{"density", 0.5}, {"rates", 1}};
  r.platform.fma_peak = 1e11;
  r.conservation.energy = 1.25e-5;
  r.errors["v"].l1 = 0.0367;
  r.deviations["M"].at = {{1, 0.03, 0.02, 0.02}, {2, 0.5, 0.4, 0.6}};
  r.joules = 3;
  r.warnings = {"3 particles were lonely"};
  const std::string text = final_table(r);
  // rates: 1 s of 2 s is 50 %, and 1 s for 10^6 updates is 1 us each.
  EXPECT_NE(text.find("rates                              1.000   50.0        1.000"), std::string::npos) << text;
  // What the phases do not account for: 2 - 1.5 s.
  EXPECT_NE(text.find("other                              0.500   25.0        0.500"), std::string::npos) << text;
  EXPECT_NE(text.find("500 k updates/s"), std::string::npos) << text;
  EXPECT_NE(text.find("10.0 GFLOP/s, 10.0 % of the measured FMA peak"), std::string::npos) << text;
  EXPECT_NE(text.find("energy 1.25e-05"), std::string::npos) << text;
  EXPECT_NE(text.find("error of v"), std::string::npos) << text;
  EXPECT_NE(text.find("0.0367"), std::string::npos) << text;
  EXPECT_NE(text.find("0.03 of 0.02, 0.5 of 0.4 to 0.6"), std::string::npos) << text;
  EXPECT_NE(text.find("3 J, 3 uJ per update"), std::string::npos) << text;  // for 10^6 updates
  EXPECT_NE(text.find("note: 3 particles were lonely"), std::string::npos) << text;
}

}  // namespace
}  // namespace sphk
