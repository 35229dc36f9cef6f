// SPDX-License-Identifier: BSD-3-Clause

// Every pair loop of every scheme with one thread a particle, each walking the tree and adding up in double one pair
// after the other, against the tiles that runs use: the same pairs, summed in another order.
#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <map>
#include <random>

#include "all_schemes.hpp"
#include "kernels/terms/artificial_conductivity.hpp"
#include "src/engine/recipe_parts.hpp"
#include "src/engine/scheme_interface.hpp"
#include "src/schemes/instantiate.hpp"
#include "src/schemes/registry.hpp"
#include "src/schemes/resolve.hpp"
#include "tests/engine/brute_force.hpp"

namespace sphk::test {
namespace {

/// Scheme S with pair loops that run by particles, those that schemes share included.
template <class S>
struct ByParticles : S {
  static constexpr bool one_thread_a_particle = true;
};
template <class S>
requires requires {
  typename S::Core;
}
struct ByParticles<S> : S {
  static constexpr bool one_thread_a_particle = true;
  using Core = ByParticles<typename S::Core>;
};

/// Its passes, for a run.
template <class Tiled>
class Reference final : public SchemePasses<BaseLayout<typename Tiled::Layout>> {
 public:
  using S = ByParticles<Tiled>;
  using L = typename S::Layout;
  using Base = BaseLayout<L>;
  explicit Reference(const typename S::Kernel& kernel) : SchemePasses<Base>(facts_of<Tiled>()), smoothing_(kernel) {}

  void run(int pass, RunOf<L>& run) const override {
    int k = 0;
    for_each_type(typename S::StepPasses{}, [&]<class P>() {
      if (k++ != pass) return;
      if constexpr (is_over_pairs<P>)
        P::template run<S>(run, smoothing_);
      else
        P::template run<L>(run);
    });
  }
  void predict(const RunOf<L>& run) const override { sphk::predict<L>(run, {}); }
  std::vector<Field> rates(const RunOf<L>&, bool) const override { return {}; }
  std::vector<Field> errors(const Particles<Base>&) const override { return {}; }

 private:
  SmoothingOf<S> smoothing_;
};

/// Row k of the columns of a run, particles in the order of the sort.
std::vector<double> row(const SavedState& saved, int k, std::size_t n) {
  const auto& bytes = saved.at("row " + std::to_string(k));
  std::vector<double> numbers(n);
  std::memcpy(numbers.data(), bytes.data(), n * sizeof(double));
  return numbers;
}

/// The largest difference of a field, over its largest value.
template <class S, class F>
double difference(const SavedState& a, const SavedState& b, std::size_t n) {
  double scale = 0, most = 0;
  for (int c = 0; c < components<F, S::dimension>; ++c) {
    const int k = component_offset<S::dimension, F, typename S::Fields> + c;
    const std::vector<double> x = row(a, k, n), y = row(b, k, n);
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_TRUE(std::isfinite(x[i]) && std::isfinite(y[i])) << F::facts.name;
      scale = std::max(scale, std::abs(x[i]));
      most = std::max(most, std::abs(x[i] - y[i]));
    }
  }
  return scale > 0 ? most / scale : most;
}

/// Compares the right-hand sides with which runs start. `numbers`: what the recipe serves, where that is not what its
/// scheme does otherwise.
template <class Facts, class R, class K>
void compare(const char* kernel, double neighbours, const Given& numbers = {}) {
  using S = Scheme<R, 3, K, double>;
  const ParticleSet gas = shaken_lattice(3, {10, 9, 8}, 0.3, true, 12);
  SimulationSettings settings{.scheme = Facts::facts.name,
                              .kernel = kernel,
                              .energy = R::ThermalForm::name,
                              .neighbours = neighbours,
                              .steps = global_steps,
                              .numbers = numbers,
                              .all_terms = true,
                              .own_units = Scale{}};
  settings.precision = "double";
  settings = resolved(settings, 3);
  SCOPED_TRACE(settings.scheme + " " + settings.energy + " " + kernel);
  const SavedState reference = make_run<BaseLayout<typename S::Layout>>(
                                   gas, settings, std::make_unique<Reference<S>>(detail::make_kernel<K>(kernel)))
                                   ->save();
  const std::size_t n = gas.size();
  if constexpr (contains<double, typename detail::PairNumbersOf<R>::type>) {
    const auto run = make_simulation(gas, settings);
    ASSERT_EQ(run->costs().bytes_per_particle, facts_of<S>().bytes_per_particle) << "another recipe serves";
    const SavedState tiles = run->save();
    for_each_type(typename S::Fields{},
                  [&]<class F>() { EXPECT_LT((difference<S, F>(reference, tiles, n)), 1e-12) << F::facts.name; });
  }
  settings.precision = "mixed";
  const SavedState mixed = make_simulation(gas, settings)->save();
  EXPECT_LT((difference<S, Acceleration>(reference, mixed, n)), 2e-6);
}

template <class Facts, class... R>
void compare_recipes(List<R...>) {
  const auto one = [&]<class Recipe>() {
    using Kernels = typename Recipe::Kernels::template in<3>;
    Given numbers;
    if constexpr (contains<ArtificialConductivitySmoothed, typename Recipe::RateTerms::List>)
      numbers.set(conductivity_signal.key, 2);
    if constexpr (is_complete<Recipe> && contains<Tabulated, Kernels>)
      compare<Facts, Recipe, Tabulated>("wc4", 60, numbers);
    else if constexpr (is_complete<Recipe>)
      compare<Facts, Recipe, CubicSpline>("cs", 48);
  };
  (one.template operator()<R>(), ...);
}

template <class Facts>
struct EveryLoop : testing::Test {};
template <class... S>
auto as_types(List<S...>) -> testing::Types<S...>;
TYPED_TEST_SUITE(EveryLoop, decltype(as_types(AllSchemes{})));

TYPED_TEST(EveryLoop, OfTilesIsThatOfSingleThreads) {
  compare_recipes<TypeParam>(typename TypeParam::Recipes{});
}

/// So many neighbours that candidates are not listed.
TEST(ManyNeighbours, OfTilesAreThoseOfSingleThreads) {
  compare<Sph, Sph::Entropy, Hoct<4>>("hoct4", 442);
}

/// Few particles of a cell, served one by one, or more of them, together: each gets what it gets where all are active.
void compare_few(double neighbours) {
  using S = Scheme<Sphs::EqualEntropy, 3, Hoct<4>, double>;
  const PassesOf<S> passes(Hoct<4>{});
  SimulationSettings settings{.scheme = "sphs", .neighbours = neighbours, .steps = global_steps};
  auto run = load_run<S>(shaken_lattice(3, {10, 10, 10}, 0.3, true, 12), settings, SmoothingOf<S>(Hoct<4>{}));
  const auto run_loops = [&] {
    for_each_type(List<SmoothingLength, Gradients, Rates>{},
                  [&]<class P>() { P::template run<S>(run, SmoothingOf<S>(Hoct<4>{})); });
  };
  for (std::size_t k = 0; k < passes.facts.passes.size(); ++k)
    if (passes.facts.passes[k].wanted(run.given)) passes.run(static_cast<int>(k), run);
  run_loops();
  using Sums = List<Support, Density, VelocityDivergence, VelocityCurl, GradVelocityDivergence, Acceleration, Heating>;
  const auto particles = run.state.as<S::Layout>();
  std::map<std::string, std::vector<double>> of_all;
  const auto for_each_sum = [&](auto&& f) {
    for_each_type(Sums{}, [&]<class F>() {
      for (int c = 0; c < components<F, 3>; ++c) f(F::facts.name + std::to_string(c), particles.at<F>(0, c));
    });
  };
  const int n = run.state.n, cells = run.state.tree.cells();
  for_each_sum([&](const std::string& name, double& first) { of_all[name].assign(&first, &first + n); });

  // One target in the first cell, two in the next, and so on, and all in some.
  auto& active = run.state.active;
  active = {false, cells, Kokkos::View<int*, MemorySpace>("cells", cells),
            Kokkos::View<TargetMask*, MemorySpace>("masks", cells)};
  std::mt19937_64 engine(7);
  for (int cell = 0; cell < cells; ++cell) {
    active.cell_numbers(cell) = cell;
    const TargetMask all = all_targets(run.state.tree, cell);
    const int wanted = cell % 4 == 3 ? std::popcount(all) : 1 + cell % 7;
    while (std::popcount(active.masks(cell)) < wanted) active.masks(cell) |= TargetMask(1) << engine() % 64 & all;
  }
  for (int i = 0; i < n; ++i)
    if (active.contains(i)) particles.at<VelocityDivergence>(i) = particles.at<Acceleration>(i, 1) = std::nan("");
  run_loops();
  for_each_sum([&](const std::string& name, double& first) {
    const std::vector<double>& before = of_all[name];
    const double most = std::abs(*std::ranges::max_element(before, {}, [](double x) { return std::abs(x); }));
    for (int i = 0; i < n; ++i) {
      if (active.contains(i))
        ASSERT_NEAR((&first)[i], before[static_cast<std::size_t>(i)], 1e-11 * most) << name << " of " << i;
      else
        ASSERT_EQ((&first)[i], before[static_cast<std::size_t>(i)]) << name << " of " << i;
    }
  });
}
TEST(FewTargets, GetWhatTheyGetAmongAllWithLists) {
  compare_few(64);
}
TEST(FewTargets, GetWhatTheyGetAmongAllWithoutLists) {
  compare_few(442);
}

/// Searches whose starts are off by 30 and 50 % end where those of the tiles do.
TEST(FarStarts, LeadSingleThreadsToTheSupportsOfTiles) {
  using S = Scheme<Sph::Entropy, 3, CubicSpline, double>;
  using Core = ByParticles<S>::Core;
  const SmoothingOf<S> smoothing{CubicSpline{}};
  SimulationSettings settings;
  settings.neighbours = 48;
  auto run = load_run<S>(shaken_lattice(3, {9, 8, 3}, 0.3, true, 12), settings, smoothing);
  const int n = run.state.n;
  std::vector<double> h, rho;
  for (int i = 0; i < n; ++i) {
    h.push_back(run.state.at<Support>(i));
    rho.push_back(run.state.at<Density>(i));
    run.state.at<Support>(i) *= i % 2 == 0 ? 0.7 : 1.5;
  }
  const SupportCounts counts =
      find_support(State<Core>{run.state.as<typename Core::Layout>(), smoothing}, run.given, 1e-7);
  EXPECT_GT(counts.evaluations, n);
  EXPECT_EQ(counts.failed + counts.capped + counts.crowded, 0);
  for (int i = 0; i < n; ++i) {
    ASSERT_NEAR(run.state.at<Support>(i), h[i], 1e-12 * h[i]) << i;
    ASSERT_NEAR(run.state.at<Density>(i), rho[i], 1e-12 * rho[i]) << i;
  }
}

}  // namespace
}  // namespace sphk::test
