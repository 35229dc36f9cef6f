// SPDX-License-Identifier: BSD-3-Clause

// The generalised family and V10's scheme against explicit sums written as R10, V10 print them, and the leading errors
// of every scheme against R10 eq 28-30. Supports, densities and pairs are those of BruteForce; all in double, so that
// what is compared differs by the order of sums alone (1e-13 of the largest term, a decade for cancellation), or by the
// table where a kernel is not on a scheme's list.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "src/schemes/make_simulation.hpp"
#include "src/schemes/osph.hpp"
#include "src/schemes/registry.hpp"
#include "tests/engine/array3.hpp"
#include "tests/engine/brute_force.hpp"
#include "tests/engine/compare_fields.hpp"

namespace sphk::test {
namespace {

constexpr double off_the_list = 1e-7;  // of tabulated kernels

/// The gas of the equations of motion: generalised density, pressure, sound speed, u and A.
struct Gas {
  std::vector<double> rho, P, c, u, A, eta;
};

/// eta, phi or zeta as a function of a particle's gas.
using Function = std::function<double(double rho, double u, double A)>;
const Function one = [](double, double, double) { return 1.0; };
const Function density = [](double rho, double, double) { return rho; };
const Function inverse_u = [](double, double u, double) { return 1 / u; };
const Function inverse_root = [](double, double, double A) { return std::pow(A, -3.0 / 5); };

struct Flavour {
  std::string scheme, energy;
  Function eta, phi, zeta;
  bool gather = false;    ///< W(h_i) in the density and grad-h in the forces
  bool standard = false;  ///< the density is S12 eq 6
};

const Flavour flavours[] = {{"sph", "entropy", one, one, one, false, true},
                            {"sph", "energy", one, one, one, false, true},
                            {"tsph", "entropy", one, density, one, false, true},
                            {"tsph", "energy", one, density, one, false, true},
                            {"gadget2", "entropy", one, one, one, true, true},
                            {"osph", "entropy", inverse_root, density, inverse_root},
                            {"osph", "energy", inverse_u, density, inverse_u},
                            {"osph-coherent", "entropy", inverse_root, inverse_root, inverse_root, true},
                            {"osph-coherent", "energy", inverse_u, inverse_u, inverse_u, true}};

class Family : public testing::TestWithParam<std::tuple<int, int>> {
 protected:
  Flavour flavour = flavours[std::get<0>(GetParam())];
  int D = std::get<1>(GetParam());
  ParticleSet particles = shaken_lattice(D,
                                         D == 3   ? Array3{7, 7, 6}
                                         : D == 2 ? Array3{12, 11, 1}
                                                  : Array3{30, 1, 1},
                                         0.3, true, 11);
  SimulationSettings settings{.scheme = flavour.scheme,
                              .kernel = "cs",
                              .precision = "double",
                              .energy = flavour.energy,
                              .neighbours = D == 3   ? 40.0
                                            : D == 2 ? 20.0
                                                     : 6.0,
                              .gamma = 5.0 / 3};
  BruteForce sums{particles, settings};
  Gas gas = evaluate();
  std::vector<double> z = weights();

  /// Neighbours and their W.
  using Weights = std::vector<std::pair<std::size_t, double>>;
  /// rho_i = eta_i sum_j (m_j/eta_j) W (R10 eq 19), eta from the observable density; where A is integrated those A with
  /// which P/((gamma-1) rho) is the u given.
  Gas evaluate() const {
    const std::size_t n = particles.size();
    const double gamma = settings.gamma;
    std::vector<double> A(n);
    for (std::size_t i = 0; i < n; ++i) A[i] = (gamma - 1) * particles.u[i] * std::pow(sums.rho[i], 1 - gamma);
    std::vector<Weights> W(n);
    for (std::size_t i = 0; i < n; ++i)
      for (const auto& pair : sums.pairs(int(i)))
        W[i].emplace_back(pair.j, flavour.gather ? sums.W_own(int(i), pair.r) : pair.W);
    Gas g = of_entropies(A, W);
    for (int round = 0; flavour.energy == "entropy" && round < 60; ++round) {
      for (std::size_t i = 0; i < n; ++i) A[i] *= particles.u[i] / g.u[i];
      g = of_entropies(A, W);
    }
    return g;
  }
  Gas of_entropies(const std::vector<double>& A, const std::vector<Weights>& W) const {
    Gas g;
    const std::size_t n = particles.size();
    const double gamma = settings.gamma;
    for (std::size_t i = 0; i < n; ++i) g.eta.push_back(flavour.eta(sums.rho[i], particles.u[i], A[i]));
    for (std::size_t i = 0; i < n; ++i) {
      double sum = 0;
      for (const auto& [j, weight] : W[i]) sum += particles.m[j] / g.eta[j] * weight;
      g.rho.push_back(flavour.standard ? sums.rho[i] : g.eta[i] * sum);
      const bool entropy = flavour.energy == "entropy";
      g.P.push_back(entropy ? A[i] * std::pow(g.rho[i], gamma) : (gamma - 1) * g.rho[i] * particles.u[i]);
      g.u.push_back(g.P[i] / ((gamma - 1) * g.rho[i]));
      g.c.push_back(std::sqrt(gamma * g.P[i] / g.rho[i]));
      g.A.push_back(g.P[i] / std::pow(g.rho[i], gamma));
    }
    return g;
  }
  /// z_i of rho/eta with h bound by n, from a finite difference of sum_j (m_j/eta_j) W(r, h) in h.
  std::vector<double> weights() const {
    std::vector<double> out(particles.size(), 0.0);
    if (!flavour.gather) return out;
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double dh = 1e-4 * sums.h[i], factor = sums.h[i] / (D * sums.n[i]);
      const double slope = (weighted(int(i), sums.h[i] + dh) - weighted(int(i), sums.h[i] - dh)) / (2 * dh);
      out[i] = -factor * slope / (1 + factor * sums.dn_dh[i]);
    }
    return out;
  }
  double weighted(int i, double h) const {
    double sum = 0;
    const auto pairs = sums.pairs(i);
    for (const auto& pair : pairs)
      if (pair.r < h) sum += particles.m[pair.j] / gas.eta[pair.j] * kernel(pair.r, h);
    return sum;
  }
  double kernel(double r, double h) const { return CubicSpline{}.norm(D) / std::pow(h, D) * CubicSpline{}(r / h).w; }
  double phi(int i) const { return flavour.phi(gas.rho[i], gas.u[i], gas.A[i]); }
  double zeta(int i) const { return flavour.zeta(gas.rho[i], gas.u[i], gas.A[i]); }
};

/// R10 eq 17 and 18; with grad-h the gradient of the energy (R10 footnote 4).
TEST_P(Family, PressureForceAndWorkAreThoseOfR10) {
  std::vector<Array3> a(particles.size(), Array3{});
  std::vector<double> work(particles.size(), 0.0);
  for (int i = 0; i < int(particles.size()); ++i)
    for (const auto& pair : sums.pairs(i)) {
      const int j = pair.j;
      const double m_i = particles.m[i], m_j = particles.m[j],
                   w = dot(difference(particles.v[i], particles.v[j]), pair.e);
      const double P_i = gas.P[i] / (gas.rho[i] * gas.rho[i]), P_j = gas.P[j] / (gas.rho[j] * gas.rho[j]);
      if (flavour.gather) {
        add(a[i],
            -P_i * gas.eta[i] * (m_j / gas.eta[j] + z[i]) * pair.dW_i -
                m_j / m_i * P_j * gas.eta[j] * (m_i / gas.eta[i] + z[j]) * pair.dW_j,
            pair.e);
        work[i] += P_i * gas.eta[i] * (m_j / gas.eta[j] + z[i]) * w * pair.dW_i;
      } else {
        add(a[i], -m_j * (P_i * phi(i) / phi(j) + P_j * phi(j) / phi(i)) * pair.dW, pair.e);
        work[i] += P_i * m_j * zeta(i) / zeta(j) * w * pair.dW;
      }
    }
  const double by_difference = flavour.gather ? 1e-6 : 1e-11;
  const double tolerance = std::max(by_difference, D == 3 && flavour.scheme == "sph" ? 0 : off_the_list);
  const auto rates = make_simulation(particles, settings)->rates(true);
  expect_near(named(rates, "AccelerationPressure"), flat(a), tolerance, "a");
  if (flavour.energy == "energy") expect_near(named(rates, "HeatingPressureWork"), work, tolerance, "du/dt");
  if (!flavour.standard) expect_near(named(rates, "GeneralDensity"), gas.rho, off_the_list, "rho");
}

/// R10 eq 28-30.
TEST_P(Family, LeadingErrorsAreThoseOfR10) {
  const std::size_t n = particles.size();
  std::vector<Array3> E0(n, Array3{});
  std::vector<double> R(6 * n, 0.0), V(6 * n, 0.0);
  for (int i = 0; i < int(n); ++i)
    for (const auto& pair : sums.pairs(i)) {
      const int j = pair.j;
      const double m_j = particles.m[j], rho_i = gas.rho[i], rho_j = gas.rho[j];
      const double g = rho_j / rho_i * phi(i) / phi(j), f = rho_j / rho_i * gas.eta[i] / gas.eta[j];
      const double e0 = m_j / rho_j * (g + 1 / g) * sums.h[i] * pair.dW, r = -m_j / rho_j * f * pair.dW,
                   v = -m_j / rho_j / g * pair.dW;
      add(E0[i], e0, pair.e);
      const auto& e = pair.e;
      const double products[6] = {e[0] * e[0], e[1] * e[1], e[2] * e[2], e[0] * e[1], e[0] * e[2], e[1] * e[2]};
      for (int k = 0; k < 6; ++k) R[6 * i + k] += r * pair.r * products[k], V[6 * i + k] += v * pair.r * products[k];
    }
  const double tolerance = 10 * off_the_list;
  const auto errors = make_simulation(particles, settings)->errors();
  expect_near(named(errors, "E0"), flat(E0), tolerance, "E0");
  expect_near(named(errors, "R"), R, tolerance, "R");
  expect_near(named(errors, "V"), V, tolerance, "V");
}

/// R10 eq 21, with d ln(eta)/dt of the rates that the run tells: of A^(-1/gamma) it is -(dA/dt)/(gamma A); of 1/u it is
/// -(du/dt)/u, where du/dt follows from dA/dt and the work -P/rho div v. Tolerance: eta_rate's finite difference.
TEST_P(Family, TheResidualOfTheContinuityEquationIsThatOfR10) {
  const std::size_t n = particles.size();
  const auto simulation = make_simulation(particles, settings);
  const auto rates = simulation->rates(false);
  const auto &dA = named(rates, "EntropyRate"), &div_v = named(rates, "VelocityDivergence");
  const double gamma = settings.gamma;
  std::vector<double> eta_rate(n, 0.0), epsilon(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const double du = dA[i] * std::pow(gas.rho[i], gamma - 1) / (gamma - 1) - gas.P[i] / gas.rho[i] * div_v[i];
    const bool of_entropy = flavour.energy == "entropy";
    if (gas.eta[i] != 1) eta_rate[i] = of_entropy ? -dA[i] / (gamma * gas.A[i]) : -du / gas.u[i];
  }
  double largest = 0;
  for (int i = 0; i < int(n); ++i)
    for (const auto& pair : sums.pairs(i)) {
      const double part =
          particles.m[pair.j] * (eta_rate[i] - eta_rate[pair.j]) * gas.eta[i] / gas.eta[pair.j] * pair.W;
      epsilon[i] += part;
      largest = std::max(largest, std::abs(part));
    }
  const auto errors = simulation->errors();
  const auto& told = named(errors, "Epsilon");
  if (flavour.scheme == "osph") EXPECT_GT(largest, 1e-3) << "nothing would be compared";
  for (std::size_t i = 0; i < n; ++i) ASSERT_NEAR(told[i], epsilon[i], 1e-6 * std::max(largest, 1e-300)) << i;
}

INSTANTIATE_TEST_SUITE_P(Flavours, Family, testing::Combine(testing::Range(0, 9), testing::Range(1, 4)),
                         [](const auto& info) {
                           std::string name = flavours[std::get<0>(info.param)].scheme;
                           std::erase(name, '-');
                           return name + flavours[std::get<0>(info.param)].energy +
                                  std::to_string(std::get<1>(info.param)) + "d";
                         });

/// Of a pair of even gas at the same place in all respects but the nearest: contrast and distance by hand.
TEST(Errors, ContrastAndNearestNeighbour) {
  ParticleSet gas = shaken_lattice(2, {10, 10, 1}, 0, true, 1);  // spacing 1/10
  gas.m.assign(100, 0.01);
  gas.u.assign(100, 1.0);
  gas.u[55] = 2;
  gas.x[55][0] += 0.04;  // one neighbour is at 0.06 now, along x
  const auto errors =
      make_simulation(gas, {.scheme = "sph", .kernel = "cs", .precision = "double", .neighbours = 20})->errors();
  const auto &contrast = named(errors, "EntropyContrast"), &nearest = named(errors, "NearestNeighbour");
  EXPECT_NEAR(nearest[55], 0.06, 1e-12);
  EXPECT_NEAR(nearest[56], 0.06, 1e-12);
  EXPECT_NEAR(nearest[0], 0.1, 1e-12);
  EXPECT_GT(contrast[55], 0.5);  // ln 2, but for the density, which A = P/rho^gamma holds as well
  EXPECT_LT(contrast[55], 0.9);
  EXPECT_LT(contrast[0], 0.05) << "the odd particle is out of reach";
}

/// The family takes any type for a free function: here Marri & White's (2003) phi = rho^(3/2), which R10 compare with.
struct DensityToThreeHalves {
  static constexpr const char* name = "rho^(3/2)";
  KOKKOS_INLINE_FUNCTION static double value(const GasValues& gas) { return Kokkos::pow(gas.rho, 1.5); }
};
struct MarriWhite {
  static constexpr SchemeFacts facts{.name = "marri-white", .summary = "phi = rho^(3/2) (Marri & White 2003)"};
  struct Entropy : EntropyFamily<One, DensityToThreeHalves> {
    using Kernels = ByDimension<List<>, List<CubicSpline>, List<>>;
  };
  using Recipes = List<Entropy>;
};

TEST(Family, TakesAUsersFreeFunction) {
  const ParticleSet gas = shaken_lattice(2, {10, 10, 1}, 0.3, true, 5);
  SimulationSettings s{.scheme = "sph", .kernel = "cs", .precision = "double", .neighbours = 20};
  const BruteForce sums(gas, s);
  std::vector<double> rho(gas.size(), 0.0), P;
  for (int i = 0; i < 100; ++i) {
    for (const auto& pair : sums.pairs(i)) rho[i] += gas.m[pair.j] * pair.W;  // R10 eq 19 with eta = 1: Wbar
    P.push_back(2.0 / 3 * gas.u[i] * rho[i]);
  }
  std::vector<Array3> a(gas.size(), Array3{});
  for (int i = 0; i < 100; ++i)
    for (const auto& pair : sums.pairs(i)) {
      const int j = pair.j;
      const double ratio = std::pow(rho[i] / rho[j], 1.5);
      add(a[i], -gas.m[j] * (P[i] / (rho[i] * rho[i]) * ratio + P[j] / (rho[j] * rho[j]) / ratio) * pair.dW, pair.e);
    }
  s.scheme = MarriWhite::facts.name;
  const auto run = make_simulation<MarriWhite>(gas, s);
  expect_near(named(run->rates(true), "AccelerationPressure"), flat(a), 1e-11, "a");
}

/// What the forces of the pseudo-coherent form take from the motion their work gives to the heat, pair by pair.
TEST(CoherentOsph, ConservesEnergyToRoundingWhereUIsIntegrated) {
  const ParticleSet gas = shaken_lattice(3, {8, 7, 6}, 0.3, true, 9);
  const SimulationSettings s{
      .scheme = "osph-coherent", .kernel = "cs", .precision = "double", .energy = "energy", .neighbours = 40};
  const auto rates = make_simulation(gas, s)->rates(true);
  const auto &a = named(rates, "AccelerationPressure"), &du = named(rates, "HeatingPressureWork");
  double power = 0, scale = 0;
  for (std::size_t i = 0; i < gas.size(); ++i) {
    const double kinetic = gas.v[i][0] * a[3 * i] + gas.v[i][1] * a[3 * i + 1] + gas.v[i][2] * a[3 * i + 2];
    power += gas.m[i] * (kinetic + du[i]);
    scale += gas.m[i] * (std::abs(kinetic) + std::abs(du[i]));
  }
  EXPECT_LT(std::abs(power), 1e-12 * scale);
}

/// Energy over a fixed time without viscosity: what is lost shrinks with dt^2 where the force is a gradient, and does
/// not where it is not.
double energy_drift(const std::string& scheme, double dt) {
  ParticleSet gas = shaken_lattice(3, {8, 8, 8}, 0.25, true, 5);
  for (Array3& v : gas.v)
    for (double& component : v) component *= 0.2;
  const SimulationSettings s{.scheme = scheme,
                             .kernel = "cs",
                             .precision = "double",
                             .neighbours = 48,
                             .courant = 10,
                             .max_dt = dt,
                             .numbers = {{"viscosity.alpha", 0}, {"viscosity.beta", 0}}};
  const auto run = make_simulation(gas, s);
  const double before = run->totals().energy();
  while (run->time() < 0.032) run->step(0.032);
  return std::abs(run->totals().energy() - before) / before;
}
TEST(CoherentOsph, ConservesEnergyToTheIntegratorsOrderWhereAIsIntegrated) {
  const double coarse = energy_drift("osph-coherent", 0.002), fine = energy_drift("osph-coherent", 0.001);
  EXPECT_LT(fine, 0.35 * coarse);  // 1/4 to leading order
  EXPECT_GT(energy_drift("osph", 0.001), 20 * fine);
}

/// V10 eq 2-7 on pairs, for the three signal velocities and without conductivity.
class V10Heating : public testing::TestWithParam<const char*> {};
TEST_P(V10Heating, IsThatOfV10) {
  const std::string signal = GetParam();
  const ParticleSet gas = shaken_lattice(2, {12, 11, 1}, 0.3, true, 3);
  const SimulationSettings s{.scheme = "v10",
                             .kernel = "cs",
                             .precision = "double",
                             .neighbours = 24,
                             .numbers = {{"viscosity.alpha", 0.9},
                                         {"viscosity.beta", 1.5},
                                         {"conductivity.alpha", signal == "none" ? 0 : 0.7},
                                         {"conductivity.signal", signal == "v1"   ? 1
                                                                 : signal == "v2" ? 2
                                                                                  : 0}},
                             .all_terms = true};
  const BruteForce sums(gas, s);
  const auto &rho = sums.rho, &P = sums.P, &c = sums.c;
  std::vector<double> smooth(gas.size(), 0.0), conducted(gas.size(), 0.0), viscous(gas.size(), 0.0);
  for (int i = 0; i < int(gas.size()); ++i)
    for (const auto& pair : sums.pairs(i)) {
      const double A = P[pair.j] / std::pow(rho[pair.j], 5.0 / 3);
      smooth[i] += gas.m[pair.j] * A * std::pow(rho[pair.j], 2.0 / 3) * pair.W;
    }
  for (int i = 0; i < int(gas.size()); ++i)
    for (const auto& pair : sums.pairs(i)) {
      const int j = pair.j;
      if (pair.r == 0) continue;
      const double rho_ij = (rho[i] + rho[j]) / 2, du = gas.u[i] - gas.u[j];
      const double dP = signal == "v2" ? smooth[i] - smooth[j] : P[i] - P[j];
      double v_u = std::sqrt(std::abs(dP) / rho_ij);
      if (signal != "price" && dP * du < 0) v_u = -v_u;
      if (signal != "none") conducted[i] += gas.m[j] / rho_ij * 0.7 * v_u * du * pair.dW;
      const double w = dot(difference(gas.v[i], gas.v[j]), pair.e);
      if (w < 0)
        viscous[i] += gas.m[j] / rho_ij * -0.5 * 0.9 * (sums.balsara[i] + sums.balsara[j]) / 2 *
                      (c[i] + c[j] - 1.5 * w) * w * w * pair.dW;
    }
  const auto rates = make_simulation(gas, s)->rates(true);
  expect_near(named(rates, "HeatingViscosity"), viscous, 10 * off_the_list, "viscous du/dt");
  expect_near(named(rates, "HeatingConductivity"), conducted, 10 * off_the_list, "conducted du/dt");
}
INSTANTIATE_TEST_SUITE_P(Signals, V10Heating, testing::Values("price", "v1", "v2", "none"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace sphk::test
