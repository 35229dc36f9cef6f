// SPDX-License-Identifier: BSD-3-Clause

// Steps of the particles' own: powers of two, no longer than asked, neighbours within a factor 4, sleepers woken.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "kernels/passes/schedule.hpp"
#include "kernels/passes/smoothing_length.hpp"
#include "kernels/smoothing/cubic_spline.hpp"
#include "src/engine/recipe_parts.hpp"
#include "src/schemes/gadget2.hpp"
#include "tests/engine/brute_force.hpp"

namespace sphk::test {
namespace {

using S = Scheme<Gadget2::Entropy, 3, CubicSpline, double>;

struct ScheduleTest : testing::Test {
  RunOf<S::Layout> run = loaded();

  static RunOf<S::Layout> loaded() {
    SimulationSettings settings;
    settings.neighbours = 48;
    settings.steps = own_steps;
    settings.courant = 0.4;
    auto run = load_run<S>(shaken_lattice(3, {12, 9, 8}, 0.3, true, 21), settings, SmoothingOf<S>(CubicSpline{}));
    StateEquation::run<typename S::Layout>(run);
    run.state.clock.tick = 1.0 / static_cast<double>(StepClock::block);
    return run;
  }
  /// Every particle asks for a step of 10^-5 to 1 of the block.
  void ask_at_random() {
    std::mt19937_64 engine(4);
    std::uniform_real_distribution<double> exponent(0, 5);
    auto& state = run.state;
    for (int i = 0; i < state.n; ++i)
      state.at<MaxSignalVelocity>(i) = state.parameters.courant * state.at<Support>(i) * std::pow(10, exponent(engine));
  }
  Ticks length(int i) const { return run.state.clock.end(i) - run.state.clock.begin(i); }
  bool are_neighbours(int i, int j) const {
    double r2 = 0;
    for (int d = 0; d < 3; ++d) {
      const double period = run.state.tree.domain.period[d];
      double x = run.state.at<Position>(i, d) - run.state.at<Position>(j, d);
      x -= period * std::round(x / period);
      r2 += x * x;
    }
    const double h = std::max(run.state.at<Support>(i), run.state.at<Support>(j));
    return r2 < h * h;
  }
};

TEST_F(ScheduleTest, StepsAreTheLargestPowersOfTwoThatWereAsked) {
  ask_at_random();
  run.schedule.limiter = false;
  assign_steps(run.state, run.schedule, 0);
  for (int i = 0; i < run.state.n; ++i) {
    EXPECT_EQ(length(i) & (length(i) - 1), 0);
    const double step = static_cast<double>(length(i)) * run.state.clock.tick, asked = run.state.step_asked(i);
    EXPECT_LE(step, asked * (1 + 1e-12));
    EXPECT_GT(2 * step, std::min(asked, 1.0) * (1 - 1e-12));
  }
}

TEST_F(ScheduleTest, StepsBeginWhereStepsOfTheirLengthDo) {
  ask_at_random();
  const Ticks start = 3 * (StepClock::block / 8);
  assign_steps(run.state, run.schedule, start);
  for (int i = 0; i < run.state.n; ++i) {
    EXPECT_EQ(start % length(i), 0);
    EXPECT_LE(run.state.clock.end(i), StepClock::block);
  }
}

/// In the first block no step is longer than what the run has behind it, whatever is asked: steps double at most.
TEST_F(ScheduleTest, StepsDoubleAtMostWhenARunStarts) {
  ask_at_random();
  run.schedule.starting = true;
  run.schedule.limiter = false;
  const Ticks behind = StepClock::block / 256;
  assign_steps(run.state, run.schedule, behind);
  int as_long = 0;
  for (int i = 0; i < run.state.n; ++i) {
    const double asked = run.state.step_asked(i) / run.state.clock.tick;
    EXPECT_LE(length(i), behind);
    EXPECT_LE(static_cast<double>(length(i)), asked * (1 + 1e-12));
    if (asked >= double(behind)) {
      EXPECT_EQ(length(i), behind);
    }
    as_long += length(i) == behind;
  }
  EXPECT_GT(as_long, 0);
  EXPECT_LT(as_long, run.state.n);
}

TEST_F(ScheduleTest, NeighboursStayWithinAFactorFour) {
  ask_at_random();
  assign_steps(run.state, run.schedule, 0);
  Ticks shortest = StepClock::block, longest = 0;
  for (int i = 0; i < run.state.n; ++i) {
    shortest = std::min(shortest, length(i)), longest = std::max(longest, length(i));
    for (int j = 0; j < i; ++j)
      if (are_neighbours(i, j)) {
        ASSERT_LE(length(i), 4 * length(j)) << i << " and " << j;
        ASSERT_LE(length(j), 4 * length(i)) << i << " and " << j;
      }
  }
  EXPECT_LT(shortest, longest) << "the limiter must not make all steps alike";
}

/// Where neighbours, or theirs, ask for unlike steps, a run begins with the shorter one; elsewhere with what is asked.
TEST_F(ScheduleTest, NeighboursBeginARunTogether) {
  auto& state = run.state;
  const int hot = 100;
  const Ticks asked = StepClock::block / 8;
  for (int i = 0; i < state.n; ++i)
    state.at<MaxSignalVelocity>(i) = state.parameters.courant * state.at<Support>(i) * (i == hot ? 64 : 8);
  run.schedule.starting = true;
  assign_steps(state, run.schedule, 0);
  std::vector<int> near_hot;
  for (int i = 0; i < state.n; ++i)
    if (i == hot || are_neighbours(i, hot)) near_hot.push_back(i);
  bool some_longer = false;
  for (int i = 0; i < state.n; ++i) {
    const bool near = std::ranges::any_of(near_hot, [&](int j) { return i == j || are_neighbours(i, j); });
    EXPECT_EQ(length(i) == asked / 8, near);
    EXPECT_LE(length(i), asked);
    some_longer = some_longer || length(i) == asked;
  }
  EXPECT_TRUE(some_longer);
}

/// Lets all particles sleep through a step of 2^power ticks, but for one that ends a short step at `now`.
struct SleepersTest : ScheduleTest {
  static constexpr int hot = 100, hot_power = StepClock::block_bits - 6;
  static constexpr Ticks asked = Ticks(1) << hot_power;

  void let_sleep(int power, Ticks now) {
    auto& state = run.state;
    for (int i = 0; i < state.n; ++i) {
      state.clock.begin(i) = 0;
      state.clock.end(i) = i == hot ? now : Ticks(1) << power;
      state.clock.power(i) = static_cast<std::uint8_t>(i == hot ? hot_power : power);
    }
    state.at<MaxSignalVelocity>(hot) = state.parameters.courant * state.at<Support>(hot) * 64;
    fit_ranges(state, run.schedule);
    EXPECT_EQ(first_end(state, run.schedule), now);
    state.clock.next = now;
    ActiveParticles::run<S::Layout>(run);
    EXPECT_EQ(run.active_count, 1);
  }
};

/// One particle ends a short step and asks for 1/64 of the block; all others sleep through it. Its neighbours are woken
/// to 1/16, theirs to 1/4; who is further away may sleep on.
TEST_F(SleepersTest, ANeighbourIsWokenAtOnce) {
  auto& state = run.state;
  const Ticks now = StepClock::block / 4;
  std::vector<double> x_before;
  for (int i = 0; i < state.n; ++i) {
    for (int d = 0; d < 3; ++d) state.at<Acceleration>(i, d) = d + 1;
    x_before.push_back(state.at<Position>(i, 0));
  }
  let_sleep(StepClock::block_bits, now);
  assign_steps(run.state, run.schedule, now);
  EXPECT_EQ(length(hot), asked);
  // A woken particle's drift went at v_0 + a T/2 for t = T/4; a step that ends there wants v_0 + a t/2: the difference
  // is a t (t - T)/2, and a = 1 along x.
  const double t = 1.0 / 4, correction = 0.5 * t * (t - 1);
  bool some_sleep = false;
  for (int i = 0; i < state.n; ++i) {
    if (i == hot) continue;
    if (are_neighbours(i, hot)) {
      EXPECT_EQ(state.clock.begin(i), now);
      EXPECT_EQ(length(i), 4 * asked);
    }
    const bool sleeps = state.clock.begin(i) == 0;
    EXPECT_NEAR(state.at<Position>(i, 0), x_before[i] + (sleeps ? 0 : correction), 1e-14);
    if (sleeps) {
      EXPECT_EQ(state.clock.end(i), StepClock::block);
      some_sleep = true;
    }
  }
  EXPECT_TRUE(some_sleep);
}

/// All positions drift; velocities, of which pairs read those near the hot particle alone, wait elsewhere.
TEST_F(SleepersTest, WhatPairsReadIsPredicted) {
  auto& state = run.state;
  StepClock& clock = state.clock;
  const Ticks now = asked;
  let_sleep(StepClock::block_bits, now);
  clock.now = 0;
  clock.dt = 0.01;
  std::vector<double> x_before, v_before;
  for (int i = 0; i < state.n; ++i) {
    clock.begin(i) = -1;  // nobody's step begins
    state.at<HalfStepVelocity>(i, 0) = 2;
    state.at<Acceleration>(i, 0) = 3;
    x_before.push_back(state.at<Position>(i, 0));
    v_before.push_back(state.at<Velocity>(i, 0));
  }
  KickDrift::run<S::Layout>(run);
  fit_cells(state, {});
  ActiveParticles::run<S::Layout>(run);
  const auto expect_predicted = [&](int i, bool predicted) {
    EXPECT_NEAR(state.at<Velocity>(i, 0), v_before[i] + (predicted ? 3 * 0.01 : 0), 1e-14) << i;
    EXPECT_EQ(clock.late(i / cell_size), predicted ? 0 : 0.01) << i;
  };
  bool some_wait = false;
  for (int i = 0; i < state.n; ++i) {
    EXPECT_NEAR(state.at<Position>(i, 0), x_before[i] + 2 * 0.01, 1e-14);
    if (i == hot || are_neighbours(i, hot)) expect_predicted(i, true);
    some_wait = some_wait || clock.late(i / cell_size) > 0;
  }
  EXPECT_TRUE(some_wait);
  predict<S::Layout>(run, {});
  for (int i = 0; i < state.n; ++i) expect_predicted(i, true);
}

/// Woken neighbours end their steps at the next multiple of 4 times what the hot one asks for, a quarter of that away.
/// Their own neighbours, whose steps are four times as long as theirs should be, sleep on: it is nominal steps that
/// count.
TEST_F(SleepersTest, AShortStepOfAWokenOneWakesNobody) {
  const Ticks now = 3 * asked;
  let_sleep(hot_power + 4, now);
  assign_steps(run.state, run.schedule, now);
  for (int i = 0; i < run.state.n; ++i) {
    if (i == hot) continue;
    const bool woken = are_neighbours(i, hot);
    EXPECT_EQ(run.state.clock.begin(i), woken ? now : 0) << i;
    EXPECT_EQ(run.state.clock.end(i), (woken ? 4 : 16) * asked) << i;
    EXPECT_EQ(run.state.clock.power(i), hot_power + (woken ? 2 : 4)) << i;
  }
}

}  // namespace
}  // namespace sphk::test
