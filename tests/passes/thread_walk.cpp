// One thread per particle, as a GPU runs the pair loops, against the tiles of the host: the same pairs, summed in
// another order.
#include <gtest/gtest.h>

#include "kernels/passes/smoothing_length.hpp"
#include "kernels/smoothing/cubic_spline.hpp"
#include "src/engine/passes_of.hpp"
#include "src/schemes/gadget2.hpp"
#include "tests/engine/brute_force.hpp"

namespace sphk::test {
namespace {

using S = Scheme<Gadget2::Entropy, 3, CubicSpline, double>;
using Adds = S::RateTerms::Adds;

struct ThreadWalkTest : testing::Test {
  static inline const SmoothingOf<S> smoothing{CubicSpline{}};
  RunOf<S::Layout> run = loaded();

  static RunOf<S::Layout> loaded() {
    SimulationSettings settings;
    settings.neighbours = 48;
    auto run = load_run<S>(shaken_lattice(3, {9, 8, 3}, 0.3, true, 12), settings, smoothing);
    StateEquation::run<typename S::Layout>(run);
    BalsaraFactor::run<typename S::Layout>(run);
    GradH::run<typename S::Layout>(run);
    return run;
  }
  template <class F>
  std::vector<double> field(const auto& columns) const {
    return {columns.template row<F>(), columns.template row<F>() + run.state.n};
  }
};

void expect_close(const std::vector<double>& a, const std::vector<double>& b, double relative) {
  double scale = 0;
  for (const double value : b) scale = std::max(scale, std::abs(value));
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], relative * scale) << i;
}

TEST_F(ThreadWalkTest, RatesEqualThoseOfTheTiles) {
  const S::RateTerms terms(run.given);
  const Columns<3, Adds> tiles("tiles", run.state.n), threads("threads", run.state.n);
  const State<S> state{run.state.as<S::Layout>(), smoothing};
  add_pair_sums("tiles", state, terms, tiles);
  Kokkos::parallel_for("threads", Kokkos::RangePolicy<ExecutionSpace>(0, run.state.n),
                       detail::PairSums<Reach::symmetric, S, S::RateTerms, Columns<3, Adds>>(state, terms, threads));
  Kokkos::fence();
  expect_close(field<Acceleration>(threads), field<Acceleration>(tiles), 1e-13);
  expect_close(field<Heating>(threads), field<Heating>(tiles), 1e-13);
  expect_close(field<MaxSignalVelocity>(threads), field<MaxSignalVelocity>(tiles), 1e-13);
}

TEST_F(ThreadWalkTest, SupportsEqualThoseOfTheTiles) {
  const std::vector<double> h = field<Support>(run.state.columns), rho = field<Density>(run.state.columns);
  for (int i = 0; i < run.state.n; ++i) run.state.at<Support>(i) *= i % 2 == 0 ? 0.7 : 1.5;
  SupportCounts counts;
  Kokkos::parallel_reduce("threads", Kokkos::RangePolicy<ExecutionSpace>(0, run.state.n),
                          detail::FindSupport<S>(State<S>{run.state.as<S::Layout>(), smoothing}, run.given, 1e-7),
                          Kokkos::Sum<SupportCounts>(counts));
  EXPECT_GT(counts.evaluations, run.state.n) << "the starts are off by 30 and 50 %";
  EXPECT_EQ(counts.failed + counts.capped + counts.crowded, 0);
  expect_close(field<Support>(run.state.columns), h, 1e-12);
  expect_close(field<Density>(run.state.columns), rho, 1e-12);
}

}  // namespace
}  // namespace sphk::test
