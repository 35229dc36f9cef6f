// SPDX-License-Identifier: BSD-3-Clause

// Linear waves of SPH on lattices against published minima, against limits, and against runs of the engine.
#include "src/stability/dispersion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "src/engine/errors.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {
namespace {

constexpr double gamma_gas = 5.0 / 3;

/// A published number and the unit of its last digit.
struct Digits {
  double value, unit;
};

struct Case {
  const char *lattice, *kernel;
  double h;
  Digits longitudinal, transverse;  ///< minima over the directions
};

class Minima : public testing::TestWithParam<Case> {};

/// Minima of omega^2/(k^2 c^2) for kappa up to pi by an independent computation, to the digits that are given, of which
/// some were cut and not rounded; h, too, has two digits after the point.
TEST_P(Minima, AreThoseOfTheTable) {
  const auto& [name, kernel, h, longitudinal, transverse] = GetParam();
  const Lattice& lattice = find_lattice(name);
  const auto least_at = [&](double support) { return least_waves(lattice, kernel, support, gamma_gas, 400); };
  const WaveModes least = least_at(h), below = least_at(h - 0.005), above = least_at(h + 0.005);
  EXPECT_NEAR(least.longitudinal, longitudinal.value,
              longitudinal.unit + 0.5 * std::abs(above.longitudinal - below.longitudinal));
  EXPECT_NEAR(least.across(), transverse.value, transverse.unit + 0.5 * std::abs(above.across() - below.across()));
}
const double h32 = lattice_support(32, 2);
INSTANTIATE_TEST_SUITE_P(Lattices, Minima,
                         testing::Values(Case{"cubic", "hoct4", 2.86, {4.04e-3, 1e-5}, {3.54e-3, 1e-5}},
                                         Case{"cubic", "hoct4", 4.75, {6.1e-4, 1e-5}, {-5e-5, 1e-5}},
                                         Case{"cubic", "ct", 3.14, {-2.4e-3, 1e-4}, {-4.9e-2, 1e-3}},
                                         Case{"cubic", "ct", 4.75, {4.3e-4, 1e-5}, {1.7e-4, 1e-5}},
                                         Case{"cubic", "cs", 2.0, {2.3e-2, 1e-3}, {-9.8e-3, 1e-4}},
                                         Case{"cubic", "cs", 3.14, {-3.8e-3, 1e-4}, {-5.2e-2, 1e-3}},
                                         Case{"square", "cs", h32, {-4.8e-3, 1e-4}, {-4.2e-2, 1e-3}},
                                         Case{"square", "liq", h32, {2.6e-3, 1e-4}, {-2.9e-2, 1e-3}},
                                         Case{"square", "ct", h32, {-7e-4, 1e-4}, {-3.3e-2, 1e-3}}));

/// Long waves are sound waves along k and nothing across it, on every lattice: to (k h)^2 and to the error of the
/// kernel's sums, which is small for many neighbours.
TEST(Dispersion, OfLongWavesIsThatOfSound) {
  for (const Lattice& lattice : lattices()) {
    const double h = lattice.dimension == 1 ? 6 : 5;
    const WaveModes modes = Dispersion(lattice, "wc6", h, gamma_gas).at({0.02, 0, 0});
    EXPECT_NEAR(modes.longitudinal, 1, 0.01) << lattice.name;
    if (lattice.dimension > 1) {
      EXPECT_NEAR(modes.transverse, 0, 0.01) << lattice.name;
    }
    if (lattice.dimension > 2) {
      EXPECT_NEAR(modes.transverse_z, 0, 0.01) << lattice.name;
    } else {
      EXPECT_TRUE(std::isnan(modes.transverse_z)) << lattice.name;
    }
  }
}

/// hcp with two particles a cell, against the same arrangement with its cell doubled along one edge: the waves of the
/// small cell are among those of the large one.
TEST(Dispersion, DoesNotDependOnTheChoiceOfTheCell) {
  const Lattice& hcp = find_lattice("hcp");
  Lattice doubled = hcp;
  for (const Array3& x : hcp.basis)
    doubled.basis.push_back({x[0] + hcp.edges[2][0], x[1] + hcp.edges[2][1], x[2] + hcp.edges[2][2]});
  for (double& x : doubled.edges[2]) x *= 2;
  const double h = lattice_support(60, 3);
  const WaveModes once = Dispersion(hcp, "hoct4", h, gamma_gas).at({0.4, 0.3, 0.2}),
                  twice = Dispersion(doubled, "hoct4", h, gamma_gas).at({0.4, 0.3, 0.2});
  EXPECT_NEAR(twice.longitudinal, once.longitudinal, 1e-9);
  EXPECT_NEAR(twice.transverse, once.transverse, 1e-9);
  EXPECT_NEAR(twice.transverse_z, once.transverse_z, 1e-9);
  EXPECT_LE(twice.relative, once.relative + 1e-9) << "more particles a cell, more ways to move";
}

/// A cubic lattice of side^3 particles of mass 1 in a periodic box, with R10's force for fixed h and A, summed over all
/// images: a_i = - sum_j (P_i/rho_i^2 + P_j/rho_j^2) grad W, P = rho^gamma for rho in units of the lattice's.
class BruteForce {
 public:
  static constexpr int side = 8;
  /// The forces' dW/dr is frozen within `core` supports, and times `force`.
  explicit BruteForce(double h, double core = 0, double force = 1) : h_(h), core_(core), force_(force) {
    for (int i = 0; i < side * side * side; ++i)
      rest_.push_back({double(i % side), double(i / side % side), double(i / (side * side))});
    rho_ = densities(rest_)[0];
  }

  /// omega^2/(k^2 c^2) of a standing wave of displacements `way` cos(k.x) from the force on the particle at 0, by
  /// central differences. With P = 1 on the lattice c^2 = gamma / rho.
  double of_wave(const Array3& k, const Array3& way) const {
    const double step = 1e-4;
    const Array3 there = force_at_origin(moved(k, way, step)), back = force_at_origin(moved(k, way, -step));
    double along = 0, k2 = 0, norm = 0;
    for (int d = 0; d < 3; ++d) {
      along += way[d] * (there[d] - back[d]) / (2 * step);
      k2 += k[d] * k[d], norm += way[d] * way[d];
    }
    return -along / norm * rho_ / (gamma_gas * k2);
  }

 private:
  std::vector<Array3> moved(const Array3& k, const Array3& way, double step) const {
    std::vector<Array3> x = rest_;
    for (Array3& a : x) {
      const double wave = step * std::cos(k[0] * a[0] + k[1] * a[1] + k[2] * a[2]);
      for (int d = 0; d < 3; ++d) a[d] += wave * way[d];
    }
    return x;
  }
  /// Calls visit(j, x_i - x_j, r) for every image of every particle within h of particle i.
  void for_neighbours(const std::vector<Array3>& x, std::size_t i, const auto& visit) const {
    for (std::size_t j = 0; j < x.size(); ++j) {
      Array3 d;
      for (int a = 0; a < 3; ++a) d[a] = x[i][a] - x[j][a] - side * std::round((x[i][a] - x[j][a]) / side);
      const double r = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
      if (r < h_) visit(j, d, r);
    }
  }
  /// The cubic spline for a support h: W = 8/(pi h^3) (1 - 6 q^2 + 6 q^3) below q = 1/2, 2 (1 - q)^3 above.
  double W(double r) const {
    const double q = r / h_;
    return 8 / (std::numbers::pi * h_ * h_ * h_) * (q < 0.5 ? 1 - 6 * q * q + 6 * q * q * q : 2 * std::pow(1 - q, 3));
  }
  double dW(double r) const {
    const double q = std::max(r / h_, core_);
    return force_ * 8 / (std::numbers::pi * std::pow(h_, 4)) *
           (q < 0.5 ? -12 * q + 18 * q * q : -6 * (1 - q) * (1 - q));
  }
  std::vector<double> densities(const std::vector<Array3>& x) const {
    std::vector<double> rho(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      for_neighbours(x, i, [&](std::size_t, const Array3&, double r) { rho[i] += W(r); });
    return rho;
  }
  Array3 force_at_origin(const std::vector<Array3>& x) const {
    const std::vector<double> rho = densities(x);
    const auto term = [&](std::size_t i) { return std::pow(rho[i] / rho_, gamma_gas) / (rho[i] * rho[i]); };
    Array3 a{};
    for_neighbours(x, 0, [&](std::size_t j, const Array3& d, double r) {
      for (int c = 0; r > 0 && c < 3; ++c) a[c] -= (term(0) + term(j)) * dW(r) * d[c] / r;
    });
    return a;
  }

  double h_, core_, force_, rho_ = 0;
  std::vector<Array3> rest_;
};

/// Along (1,1,0) the two waves across k differ: one moves along (1,-1,0), one along z.
TEST(Dispersion, HasBothWavesAcrossKAsForcesHaveThem) {
  const double h = 2.3, kappa = std::numbers::pi / 2;
  const Dispersion dispersion(find_lattice("cubic"), "cs", h, gamma_gas);
  const BruteForce forces(h);
  const WaveModes diagonal = dispersion.at({kappa, kappa, 0});
  EXPECT_NEAR(diagonal.transverse, forces.of_wave({kappa, kappa, 0}, {1, -1, 0}), 1e-6);
  EXPECT_NEAR(diagonal.transverse_z, forces.of_wave({kappa, kappa, 0}, {0, 0, 1}), 1e-6);
  EXPECT_NEAR(diagonal.longitudinal, forces.of_wave({kappa, kappa, 0}, {1, 1, 0}), 1e-6);
  EXPECT_GT(std::abs(diagonal.transverse - diagonal.transverse_z), 1e-3);
  const WaveModes axis = dispersion.at({kappa, 0, 0});
  EXPECT_NEAR(axis.transverse, forces.of_wave({kappa, 0, 0}, {0, 1, 0}), 1e-6);
  EXPECT_NEAR(axis.transverse_z, axis.transverse, 1e-9) << "the lattice has four equal sides around k";
}

/// HYDRA's forces are steeper than its density, those of ct-cs are the core triangle's, whose norm is 2.535350 to the
/// cubic spline's 2.546479 (R10 eq 45): their waves are those of both, not of one.
TEST(Dispersion, OfForcesApartFromTheDensityIsThatOfBoth) {
  const double h = 2.9, kappa = std::numbers::pi / 2, ct = 2.535350 / 2.546479;
  for (const auto& [kernel, force] : {std::pair("hydra", 1.0), std::pair("ct-cs", ct)}) {
    const BruteForce forces(h, 1.0 / 3, force);
    const WaveModes modes = Dispersion(find_lattice("cubic"), kernel, h, gamma_gas).at({kappa, kappa, 0});
    EXPECT_NEAR(modes.longitudinal, forces.of_wave({kappa, kappa, 0}, {1, 1, 0}), 1e-5) << kernel;
    EXPECT_NEAR(modes.transverse, forces.of_wave({kappa, kappa, 0}, {1, -1, 0}), 1e-5) << kernel;
  }
}

TEST(Dispersion, RefusesUnknownLatticesAndKernels) {
  EXPECT_THROW(find_lattice("cubical"), InputError);
  EXPECT_THROW(Dispersion(find_lattice("cubic"), "no such kernel", 2, gamma_gas), std::invalid_argument);
}

/// How the amplitude of a small transverse wave along (1,1,0) grows in a run, for a displacement along `push`.
double grown(const Array3& push, double neighbours, double end) {
  constexpr int side = 8;
  const double amplitude = 1e-6;
  const auto place = [](int i) { return Array3{i % side + 0.5, i / side % side + 0.5, i / (side * side) + 0.5}; };
  const auto wave = [](const Array3& x) { return std::cos(std::numbers::pi / 2 * (x[0] + x[1])); };
  ParticleSet gas;
  gas.dimension = 3;
  gas.box = {{0, 0, 0}, {side, side, side}, {true, true, true}};
  for (int i = 0; i < side * side * side; ++i) {
    Array3 x = place(i);
    const double shift = amplitude * wave(x);
    for (int d = 0; d < 3; ++d) x[d] += shift * push[d];
    gas.x.push_back(x);
    gas.v.push_back({});
    gas.m.push_back(1);
    gas.u.push_back(1);
  }
  SimulationSettings s;
  s.scheme = "sph", s.kernel = "cs", s.neighbours = neighbours, s.precision = "double", s.courant = 0.05;
  s.numbers = {{"viscosity.alpha", 0}, {"viscosity.beta", 0}};
  const auto run = make_simulation(gas, s);
  while (run->time() < end) run->step(end);
  const Snapshot after = run->snapshot();
  const auto& x = after.field("Coordinates").values;
  double sum = 0, norm = 0;
  for (int i = 0; i < side * side * side; ++i) {
    const Array3 from = place(i);
    for (int d = 0; d < 3; ++d) sum += wave(from) * push[d] * (x[3 * i + d] - from[d]);
    norm += wave(from) * wave(from);
  }
  return sum / (norm * amplitude);
}

/// A transverse wave that the map calls unstable leaves the lattice as cosh(sigma t), sigma^2 = -omega^2; h hardly
/// changes in such a wave, as the map assumes. The faster of the two polarisations is the map's.
TEST(Dispersion, PredictsHowARunLeavesAnUnstableLattice) {
  const double neighbours = 128, kappa = std::numbers::pi / 2;
  const WaveModes modes =
      Dispersion(find_lattice("cubic"), "cs", lattice_support(neighbours, 3), gamma_gas).at({kappa, kappa, 0});
  ASSERT_LT(modes.across(), -0.01);
  const double k2 = 2 * kappa * kappa, c2 = gamma_gas * (gamma_gas - 1);  // of u = 1
  const double sigma = std::sqrt(-modes.across() * k2 * c2), end = 3 / sigma, half = std::sqrt(0.5);
  const double fastest = std::max(grown({half, -half, 0}, neighbours, end), grown({0, 0, 1}, neighbours, end));
  EXPECT_NEAR(fastest, std::cosh(3), 0.02 * std::cosh(3));
}

}  // namespace
}  // namespace sphk
