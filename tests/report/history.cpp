// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/history.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/engine/errors.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> words;
  std::stringstream stream(line);
  for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
  return words;
}

/// The value of a column in a row (0 is the first below the names).
double column(const std::string& text, const std::string& name, int row) {
  std::stringstream stream(text);
  std::string line;
  std::getline(stream, line);
  const auto names = split(line);
  for (int k = 0; k <= row; ++k) std::getline(stream, line);
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) throw std::out_of_range(name);
  return std::stod(split(line).at(static_cast<std::size_t>(at - names.begin())));
}

TEST(History, HoldsEveryColumnOfTheContract) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "history.csv";
  Totals totals;
  totals.mass = 1.5;
  totals.kinetic = 0.25;
  totals.thermal = 2;
  totals.momentum = {1, 2, 3};
  totals.angular_momentum = {4, 5, 6};
  totals.momentum_sizes = 14, totals.angular_momentum_sizes = 15;
  totals.max_speed = 7;
  totals.min_density = 8, totals.max_density = 9, totals.min_pressure = 10, totals.max_pressure = 11;
  totals.min_entropy = 12, totals.max_entropy = 13;
  StepReport step;
  step.step = 42, step.time = 0.1, step.dt = 1e-3;
  History(path).add(step, totals, {.energy = 0.5}, {{"l1_v", 0.04}});
  const std::string text = read_text(path);
  const std::pair<const char*, double> expected[] = {{"step", 42},
                                                     {"time", 0.1},
                                                     {"dt", 1e-3},
                                                     {"kinetic_energy", 0.25},
                                                     {"thermal_energy", 2},
                                                     {"total_energy", 2.25},
                                                     {"momentum_x", 1},
                                                     {"momentum_y", 2},
                                                     {"momentum_z", 3},
                                                     {"angular_momentum_x", 4},
                                                     {"angular_momentum_y", 5},
                                                     {"angular_momentum_z", 6},
                                                     {"momentum_sizes", 14},
                                                     {"angular_momentum_sizes", 15},
                                                     {"mass", 1.5},
                                                     {"max_speed", 7},
                                                     {"min_rho", 8},
                                                     {"max_rho", 9},
                                                     {"min_P", 10},
                                                     {"max_P", 11},
                                                     {"min_A", 12},
                                                     {"max_A", 13},
                                                     {"energy_drift", 0.5},
                                                     {"l1_v", 0.04}};
  for (const auto& [name, value] : expected) EXPECT_EQ(column(text, name, 0), value) << name;
}

TEST(History, KeepsItsColumnsWhenMeasuresChange) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "history.csv";
  History history(path);
  history.add({}, {}, {}, {{"a", 1}, {"b", 2}});
  history.add({}, {}, {}, {{"b", 3}, {"c", 4}});
  const std::string text = read_text(path);
  EXPECT_TRUE(std::isnan(column(text, "a", 1)));
  EXPECT_EQ(column(text, "b", 1), 3);
  EXPECT_THROW(column(text, "c", 1), std::out_of_range);
}

TEST(History, NumbersSurviveTheText) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "history.csv";
  Totals totals;
  totals.mass = 0.1 + 0.2;
  History(path).add({}, totals, {}, {});
  EXPECT_EQ(column(read_text(path), "mass", 0), 0.1 + 0.2);
}

TEST(History, AFolderThatIsMissingIsAnInputError) {
  EXPECT_THROW(History("/nonexistent/folder/history.csv"), InputError);
}

}  // namespace
}  // namespace sphk
