// SPDX-License-Identifier: BSD-3-Clause

// Whole runs against exact solutions. Bounds are the peers' or the papers' own figures for the same problem and
// resolution, or follow from the exact solution; none comes from a run of this code.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "src/report/error_budget.hpp"
#include "src/run/problem.hpp"
#include "src/schemes/registry.hpp"

namespace sphk::test {
namespace {

using Keys = std::vector<std::pair<std::string, std::string>>;

struct Result {
  Settings settings;
  Snapshot end;
  Totals before, after;
  std::map<std::string, ErrorNorm> errors;
  ErrorBudget budget;  ///< at the end

  double energy_drift() const { return std::abs(after.energy() / before.energy() - 1); }
};

Result run_scene(const std::string& name, const Keys& keys) {
  std::vector<Override> overrides;
  for (const auto& [key, text] : keys) overrides.push_back({key, text, key + "=" + text});
  const Problem problem = resolve_problem(name, overrides);
  const Scene& scene = *problem.scene;
  Result result;
  result.settings = problem.settings;
  const auto run = make_simulation(scene.build(result.settings), simulation_settings(result.settings));
  result.before = run->totals();
  const double end = result.settings.real("time.end");
  while (run->time() < end) run->step(end);
  result.after = run->totals();
  result.end = run->snapshot();
  result.errors = scene.errors(result.settings, result.end);
  result.budget = error_budget(result.end, run->errors());
  return result;
}

/// Sod's tube, gamma 5/3, glass, 64 x 32 x 32 + 32 x 16 x 16: GADGET-2 reaches 0.0346 with 50 neighbours, the best of
/// four peers, all measured at the bins' centres.
TEST(Accuracy, SodOnAGlassIsNoWorseThanTheBestPeer) {
  const Result sod = run_scene("sod", {{"sph.scheme", "gadget2"}, {"sph.neighbours", "50"}});
  ASSERT_EQ(sod.end.size(), 73728u);
  EXPECT_LE(sod.errors.at("v_centres").l1, 0.0346);
  EXPECT_LT(sod.energy_drift(), 5e-3);
}

/// Gresho's vortex, 32 x 32 x 8 lattice, t = 1: GADGET-2 0.174 with 50 neighbours; S12 Fig. 6 has CS42 always above
/// 0.10. The lattice breaks up by chance: runs that differ in a digit scatter, and GADGET-2's figure is of one such
/// run.
TEST(Accuracy, GreshoWith50NeighboursIsThatOfGadget2) {
  std::vector<double> l1;
  for (const char* neighbours : {"49.98", "49.99", "50", "50.01"})
    l1.push_back(run_scene("gresho", {{"scene.n", "32"},
                                      {"scene.layers", "8"},
                                      {"sph.scheme", "gadget2"},
                                      {"sph.neighbours", neighbours},
                                      {"time.end", "1"}})
                     .errors.at("v_centres")
                     .l1);
  const double n = double(l1.size()), mean = std::accumulate(l1.begin(), l1.end(), 0.0) / n;
  double variance = 0;
  for (const double each : l1) variance += (each - mean) * (each - mean) / (n - 1);
  EXPECT_LE(mean, 0.174 + 3 * std::sqrt(variance * (1 + 1 / n)));
  EXPECT_LT(variance, 0.01 * 0.174 * 0.174) << "a scatter of a tenth would let anything pass";
  EXPECT_GE(mean, 0.10);
}

/// Sedov's blast: the shock stands at r = 1.15 (E t^2/rho)^(1/5); S12 conserve energy to 5 %. The densest spherical
/// shell lies within half a support radius of the exact front.
TEST(Accuracy, SedovShockStandsWhereItMust) {
  const Result sedov = run_scene("sedov", {{"scene.n", "32"}, {"sph.scheme", "gadget2"}});
  EXPECT_LT(sedov.energy_drift(), 0.05);
  const auto exact = find_scene("sedov").exact(sedov.settings);
  const double t = sedov.end.time, dr = 0.01;
  double front = 0;
  for (double r = 0.5; r > 0.01; r -= 1e-4)
    if (exact({r, 0, 0}, t).rho > 2) {
      front = r;
      break;
    }
  ASSERT_GT(front, 0.1);
  const auto &x = sedov.end.field("Coordinates").values, &rho = sedov.end.field("Densities").values;
  const auto& h = sedov.end.field("SmoothingLength").values;
  std::map<int, std::pair<double, int>> shells;
  double h_at_front = 0;
  for (std::size_t i = 0; i < sedov.end.size(); ++i) {
    const double r = std::hypot(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
    auto& [sum, count] = shells[static_cast<int>(r / dr)];
    sum += rho[i], ++count;
    if (std::abs(r - front) < dr) h_at_front = std::max(h_at_front, h[i]);
  }
  double densest = 0, peak = 0;
  for (const auto& [k, shell] : shells)
    if (shell.second > 20 && shell.first / shell.second > peak) {
      peak = shell.first / shell.second;
      densest = (k + 0.5) * dr;
    }
  EXPECT_NEAR(densest, front, 0.5 * h_at_front);
  EXPECT_GT(peak, 2) << "a strong shock, smeared, out of 4";
}

/// The same with SPHS on steps of the particles' own. S12 lose 5 % with eq 7 and entropies; with the thermal energy in
/// their place, or the momentum equation that belongs to entropies, the pairs conserve it, and 1 % is left to the
/// steps.
TEST(Accuracy, SedovWithSphsKeepsItsEnergyOnUnlikeSteps) {
  const auto drift = [](const char* scheme, const char* energy) {
    return run_scene("sedov", {{"scene.n", "32"}, {"sph.scheme", scheme}, {"sph.energy", energy}}).energy_drift();
  };
  EXPECT_LT(drift("sphs", "entropy"), 0.05);
  EXPECT_LT(drift("sphs", "energy"), 0.01);
  EXPECT_LT(drift("sphs-conservative", "entropy"), 0.01);
}

double measure(const Result& result, const std::string& scene, const std::string& name) {
  for (const auto& [key, value] : find_scene(scene).measures(result.settings, result.end))
    if (key == name) return value;
  throw std::out_of_range("no measure " + name);
}

/// Saitoh & Makino (2009): all energy in one particle of cold gas, steps of the particles' own. While neighbours stay
/// within a factor 4 the blast ends within 1 % of Sedov's radius and of its energy; without that it is no blast at all.
TEST(Accuracy, PointExplosionNeedsTheLimiterOfTheSteps) {
  const Keys keys{{"scene.n", "32"}};
  const Result blast = run_scene("point-explosion", keys);
  EXPECT_LT(blast.energy_drift(), 0.01);
  const double radius = measure(blast, "point-explosion", "blast_radius_exact");
  EXPECT_NEAR(measure(blast, "point-explosion", "blast_radius"), radius, 0.01 * radius);
  Keys without = keys;
  without.emplace_back("time.limiter", "false");
  EXPECT_GT(run_scene("point-explosion", without).energy_drift(), 0.1);
}

/// Gresho's vortex on 32 x 32 x 4: S12 Fig. 6 has classic SPH with 42 neighbours always above 0.10, and SPHS with 442
/// below it; the form with E0 subtracted is better still.
TEST(Accuracy, GreshoWithSphsIsBetterThanClassicAndBetterStillWithoutE0) {
  const auto error = [](const char* scheme) {
    return run_scene("gresho", {{"scene.n", "32"}, {"sph.scheme", scheme}}).errors.at("v").l1;
  };
  const double sphs = error("sphs"), morris = error("sphs-morris");
  EXPECT_LT(sphs, 0.10);
  EXPECT_LT(morris, sphs);
}

/// Largest deviation of P from P* = 0.293945 within half a support of the contact of Sod's tube, gamma 5/3, at 0.841195
/// t.
double pressure_blip(const Result& sod) {
  const double contact = 0.841195 * 0.2, P_star = 0.293945;
  const auto &x = sod.end.field("Coordinates").values, &P = sod.end.field("Pressures").values;
  const auto& h = sod.end.field("SmoothingLength").values;
  double most = 0;
  for (std::size_t i = 0; i < sod.end.size(); ++i)
    if (std::abs(x[3 * i] - contact) < 0.5 * h[i]) most = std::max(most, std::abs(P[i] / P_star - 1));
  return most;
}

/// S12 Fig. 3: where classic SPH has a blip of the pressure at the contact, SPHS with its entropy dissipation is smooth
/// (here: at most two thirds of it), and conserves energy to S12's 1 % (Fig. 10).
TEST(Accuracy, SodWithSphsSmoothsThePressureBlipOfClassicSph) {
  const auto run = [](const char* scheme, const char* kernel, const char* neighbours) {
    return run_scene("sod", {{"scene.n", "64"},
                             {"scene.across", "16"},
                             {"sph.scheme", scheme},
                             {"sph.kernel", kernel},
                             {"sph.neighbours", neighbours}});
  };
  const Result sphs = run("sphs", "hoct4", "442"), classic = run("gadget2", "cs", "42");
  EXPECT_LT(sphs.energy_drift(), 0.01);
  EXPECT_LT(pressure_blip(sphs), 2.0 / 3 * pressure_blip(classic));
}

/// Noh's problem in 1D, gamma 5/3: rho = 4 behind the shock at t/3. The plateau away from wall heating is exact jump
/// physics.
TEST(Accuracy, NohIn1dCompressesFourfold) {
  const Result noh =
      run_scene("noh", {{"scene.dimension", "1"}, {"scene.n", "100"}, {"sph.scheme", "gadget2"}, {"time.end", "0.6"}});
  const auto &x = noh.end.field("Coordinates").values, &rho = noh.end.field("Densities").values;
  const auto& v = noh.end.field("Velocities").values;
  int inside = 0;
  for (std::size_t i = 0; i < noh.end.size(); ++i) {
    const double r = std::abs(x[3 * i]);
    if (r > 0.08 && r < 0.16) {
      EXPECT_NEAR(rho[i], 4, 0.2) << "at " << x[3 * i];
      EXPECT_NEAR(v[3 * i], 0, 0.05) << "at " << x[3 * i];
      ++inside;
    }
    if (r > 0.24 && r < 0.3) EXPECT_NEAR(rho[i], 1, 0.05) << "ahead of the shock at " << x[3 * i];
  }
  EXPECT_GT(inside, 20);
}

/// Density of a lattice by the smoothing kernels of TARGETS' table, with the constraint's own h.
TEST(Accuracy, LatticeDensityIsThatOfTheKernel) {
  const struct {
    const char *kernel, *neighbours;
    double density;
  } cases[] = {{"cs", "32", 0.9991},  {"ct", "32", 1.0728},    {"ct", "128", 1.0166},
               {"liq", "32", 1.0671}, {"hoct4", "96", 1.0500}, {"hoct4", "442", 1.0076}};
  for (const auto& c : cases) {
    const Result box = run_scene("uniform", {{"scene.n", "8"},
                                             {"scene.lattice", "cubic"},
                                             {"scene.jitter", "0"},
                                             {"time.end", "0"},
                                             {"sph.precision", "double"},
                                             {"sph.kernel", c.kernel},
                                             {"sph.neighbours", c.neighbours}});
    for (const double rho : box.end.field("Densities").values)
      ASSERT_NEAR(rho, c.density, 6e-5) << c.kernel << c.neighbours;
  }
}

/// R10 Figs. 4 and A1, sec 5.2.3, KH 1:2 at one tau_KH: away from the layers' edges E0 is small and falls with the
/// neighbour number; at them TSPH's is "two to three orders of magnitude" larger at n = 256, which at n = 32 must leave
/// one; and OSPH's is "reduced by over an order of magnitude". At n = 32 the kernel of 442 neighbours is half as wide
/// as a layer: half an order is asked for.
TEST(Accuracy, E0OfKh12FallsWithTheNeighboursAndWithOsph) {
  const auto budget = [](const char* scheme, const char* kernel, const char* neighbours, const char* temperatures) {
    return run_scene("kh12", {{"scene.n", "32"},
                              {"time.end", "4.82118"},
                              {"sph.scheme", scheme},
                              {"sph.kernel", kernel},
                              {"sph.neighbours", neighbours},
                              {"scene.temperatures", temperatures}})
        .budget;
  };
  const ErrorBudget ct32 = budget("tsph", "ct", "32", "smoothed"), ct128 = budget("tsph", "ct", "128", "smoothed"),
                    tsph = budget("tsph", "hoct4", "442", "smoothed"), osph = budget("osph", "hoct4", "442", "exact"),
                    sph = budget("sph", "cs", "128", "smoothed");
  EXPECT_LT(ct128.bulk.mean, 0.7 * ct32.bulk.mean);
  EXPECT_LT(tsph.bulk.mean, ct128.bulk.mean);
  EXPECT_GT(tsph.boundary.mean, 10 * tsph.bulk.mean);
  EXPECT_LT(osph.boundary.mean, tsph.boundary.mean / 5);
  // CS with 128 neighbours clumps, HOCT4 with 442 does not (R10 sec 5.2.1).
  EXPECT_LT(sph.nearest, 0.5);
  EXPECT_GT(osph.nearest, 0.8);
}

/// R10 Fig. 7: at the contact of Sod's tube SPH has a blip of the pressure, with OSPH "the pressure blip is now gone".
TEST(Accuracy, SodWithOsphHasNoPressureBlip) {
  const auto blip = [](const char* scheme) {
    return pressure_blip(run_scene(
        "sod", {{"scene.across", "12"}, {"sph.scheme", scheme}, {"sph.kernel", "hoct4"}, {"sph.neighbours", "442"}}));
  };
  EXPECT_LT(blip("osph"), 0.5 * blip("sph"));
}

}  // namespace
}  // namespace sphk::test
