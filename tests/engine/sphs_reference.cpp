// SPDX-License-Identifier: BSD-3-Clause
#include "tests/engine/sphs_reference.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <utility>

#include "tests/engine/array3.hpp"

namespace sphk::test {

namespace {

constexpr double n_s = 0.05, alpha_max = 1;  // S12 eq 21

/// 1, x, y, z, x2, y2, z2, xy, xz, yz or what of it exists in D dimensions (S12 eq 28).
Eigen::RowVectorXd polynomial(int D, const Array3& x) {
  Eigen::RowVectorXd basis(1 + D + D * (D + 1) / 2);
  int k = 0;
  basis[k++] = 1;
  for (int a = 0; a < D; ++a) basis[k++] = x[a];
  for (int a = 0; a < D; ++a) basis[k++] = x[a] * x[a];
  for (int a = 0; a < D; ++a)
    for (int b = a + 1; b < D; ++b) basis[k++] = x[a] * x[b];
  return basis;
}

/// d2/dx_a dx_b at the origin of the polynomial with these coefficients.
double second_derivative(int D, const Eigen::VectorXd& coefficients, int a, int b) {
  if (a == b) return 2 * coefficients[1 + D + a];
  return coefficients[1 + 2 * D + a + b - 1];  // xy, xz, yz: a + b = 1, 2, 3
}

TermRates no_rates(std::size_t size) {
  return {std::vector<Array3>(size), std::vector<double>(size), std::vector<double>(size)};
}

}  // namespace

SphsReference::SphsReference(const ParticleSet& particles, const SimulationSettings& settings, SphsOptions options)
    : gas(particles, settings), particles_(particles), options_(std::move(options)), gamma_(settings.gamma) {
  const std::size_t size = particles.size();
  const int last = static_cast<int>(size);
  for (auto* field :
       {&A, &div_v, &condition, &alpha_loc, &balsara, &v_max, &alpha_viscous, &alpha, &mass_drho, &dA_dt, &dm_dt})
    field->assign(size, 0);
  for (auto* field : {&curl_v, &grad_div_v, &a}) field->assign(size, Array3{});
  for (auto* term : {&pressure, &viscosity, &entropy, &mass}) *term = no_rates(size);
  for (int i = 0; i < last; ++i) pairs_.push_back(gas.pairs(i));
  for (int i = 0; i < last; ++i) A[i] = gas.P[i] * std::pow(gas.rho[i], -gamma_);
  for (int i = 0; i < last; ++i) fit_velocity(i);
  for (int i = 0; i < last; ++i) set_switch(i);
  for (int i = 0; i < last; ++i) pressure_and_viscosity(i);
  for (int i = 0; i < last; ++i) entropy_dissipation(i);
  for (int i = 0; i < last; ++i) mass_exchange(i);
  for (int i = 0; i < last; ++i) density_of_exchange(i);
  for (int i = 0; i < last; ++i) sum_terms(i);
}

/// S12 eq 27 as a least squares problem: the rows are sqrt(m_j Wbar) times the basis at (x_j - x_i)/h_i. A QR of the
/// rows loses half the digits that the moment matrix loses.
void SphsReference::fit_velocity(int i) {
  const int D = particles_.dimension, terms = 1 + D + D * (D + 1) / 2;
  const auto rows = static_cast<Eigen::Index>(pairs_[i].size());
  Eigen::MatrixXd design(rows, terms), values(rows, D);
  for (Eigen::Index k = 0; k < rows; ++k) {
    const auto& pair = pairs_[i][k];
    const double root = std::sqrt(particles_.m[pair.j] * pair.W);
    Array3 x{};
    add(x, -pair.r / gas.h[i], pair.e);
    design.row(k) = root * polynomial(D, x);
    for (int d = 0; d < D; ++d) values(k, d) = root * (particles_.v[pair.j][d] - particles_.v[i][d]);
  }
  const Eigen::VectorXd moments =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(design.transpose() * design).eigenvalues();
  condition[i] = moments[0] > 0 ? moments[terms - 1] / moments[0] : INFINITY;
  const Eigen::MatrixXd fit = design.colPivHouseholderQr().solve(values);

  const double h = gas.h[i];
  const auto slope = [&](int of, int along) { return of < D && along < D ? fit(1 + along, of) / h : 0; };
  for (int d = 0; d < D; ++d) {
    div_v[i] += slope(d, d);
    for (int b = 0; b < D; ++b)
      grad_div_v[i][d] += second_derivative(D, fit.col(b), std::min(b, d), std::max(b, d)) / (h * h);
  }
  curl_v[i] = {slope(2, 1) - slope(1, 2), slope(0, 2) - slope(2, 0), slope(1, 0) - slope(0, 1)};
}

void SphsReference::set_switch(int i) {
  const double h = gas.h[i], c = gas.c[i], div = std::abs(div_v[i]), curl = std::sqrt(dot(curl_v[i], curl_v[i]));
  const double convergence = h * h * std::sqrt(dot(grad_div_v[i], grad_div_v[i]));
  alpha_loc[i] = div_v[i] < 0 ? alpha_max * convergence / (convergence + h * div + n_s * c) : 0;
  balsara[i] = div / (div + curl + 1e-4 * c / h);
  alpha_viscous[i] = alpha[i] = options_.alpha.empty() ? alpha_loc[i] : options_.alpha[i];
  if (options_.balsara != BalsaraOn::nothing) alpha_viscous[i] *= balsara[i];
  if (options_.balsara == BalsaraOn::everything) alpha[i] *= balsara[i];
  v_max[i] = 2 * c;
  for (const auto& pair : pairs_[i]) v_max[i] = std::max(v_max[i], gas.c[i] + gas.c[pair.j] - 3 * approach(i, pair));
}

double SphsReference::approach(int i, const BruteForce::Pair& pair) const {
  return dot(difference(particles_.v[i], particles_.v[pair.j]), pair.e);
}

/// S12 eq 29-31, without the second alpha_ij of eq 31.
void SphsReference::pressure_and_viscosity(int i) {
  const double per_density = gas.P[i] / (gas.rho[i] * gas.rho[i]), z = gas.z(i);
  for (const auto& pair : pairs_[i]) {
    const int j = pair.j;
    const double m = particles_.m[j], w = approach(i, pair);
    add(pressure.dv[i], gas.pressure_force(options_.momentum, i, pair), pair.e);
    pressure.du[i] += per_density * (m + z) * pair.dW_i * w;
    if (w >= 0) continue;
    const double alpha_ij = options_.alpha_v * 0.5 * (alpha_viscous[i] + alpha_viscous[j]);
    const double Pi = -0.5 * alpha_ij * (gas.c[i] + gas.c[j] - 3 * w) * w / (0.5 * (gas.rho[i] + gas.rho[j]));
    add(viscosity.dv[i], -m * Pi * pair.dW, pair.e);
    viscosity.du[i] += 0.5 * m * Pi * w * pair.dW;
  }
}

double SphsReference::exchange(int i, const BruteForce::Pair& pair) const {
  const int j = pair.j;
  const double v_sig = std::max(0.0, gas.c[i] + gas.c[j] - 3 * approach(i, pair));
  const double limiter = std::abs(gas.P[i] - gas.P[j]) / (gas.P[i] + gas.P[j]);
  return 0.5 * (alpha[i] + alpha[j]) * v_sig * limiter / (0.5 * (gas.rho[i] + gas.rho[j])) * pair.dW;
}

/// S12 eq 33; du = rho^(gamma-1) / (gamma-1) dA.
void SphsReference::entropy_dissipation(int i) {
  double dA = 0;
  for (const auto& pair : pairs_[i]) {
    const int j = pair.j;
    const double carried = A[j] * std::pow(gas.rho[j] / gas.rho[i], gamma_ - 1);
    dA += options_.alpha_A * particles_.m[j] * exchange(i, pair) * (A[i] - carried);
  }
  entropy.du[i] = dA * std::pow(gas.rho[i], gamma_ - 1) / (gamma_ - 1);
}

/// S12 eq 36: F is the mass that i gains from j.
void SphsReference::mass_exchange(int i) {
  const double m_i = particles_.m[i], u_i = particles_.u[i];
  const Array3& v_i = particles_.v[i];
  for (const auto& pair : pairs_[i]) {
    const int j = pair.j;
    const double m_j = particles_.m[j], u_j = particles_.u[j];
    const Array3& v_j = particles_.v[j];
    const double F = options_.alpha_m * 0.5 * (m_i + m_j) * exchange(i, pair) * (m_i - m_j);
    mass.dm[i] += F;
    if (options_.mass == MassForm::appendix_e) {
      add(mass.dv[i], F / m_i, v_j);
      mass.du[i] += F / m_i * (0.5 * dot(v_j, v_j) + u_j);
    } else if (options_.mass == MassForm::donor && F > 0) {
      const Array3 v_ij = difference(v_i, v_j);
      add(mass.dv[i], -F / m_i, v_ij);
      mass.du[i] += F / m_i * (u_j - u_i + 0.5 * dot(v_ij, v_ij));
    }
  }
  if (options_.mass != MassForm::s12) return;
  const double gained = mass.dm[i] / m_i;  // S12 eq 39-40
  add(mass.dv[i], -gained, v_i);
  mass.du[i] = gained * (0.5 * dot(v_i, v_i) - u_i);
}

/// S12 eq 42, which is not zero.
void SphsReference::density_of_exchange(int i) {
  for (const auto& pair : pairs_[i]) mass_drho[i] += mass.dm[pair.j] * gas.W_own(i, pair.r);
  if (options_.pay_for_density) mass.du[i] -= gas.P[i] / (gas.rho[i] * gas.rho[i]) * mass_drho[i];
}

void SphsReference::sum_terms(int i) {
  for (const auto* term : {&pressure, &viscosity, &mass}) add(a[i], 1, term->dv[i]);
  const double heating = viscosity.du[i] + entropy.du[i] + mass.du[i];
  dA_dt[i] = (gamma_ - 1) * std::pow(gas.rho[i], 1 - gamma_) * heating;
  dm_dt[i] = mass.dm[i];
}

Budget SphsReference::budget(const TermRates& term) const {
  Budget total;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const double m = particles_.m[i], dm = term.dm[i];
    const Array3 &v = particles_.v[i], &dv = term.dv[i];
    total.mass.add(dm);
    for (int d = 0; d < 3; ++d) total.momentum[d].add(m * dv[d]), total.momentum[d].add(dm * v[d]);
    total.energy.add(m * dot(v, dv));
    total.energy.add(m * term.du[i]);
    total.energy.add(dm * (0.5 * dot(v, v) + particles_.u[i]));
  }
  return total;
}

Sum SphsReference::energy_of_exchange() const {
  Sum energy = budget(mass).energy;
  for (std::size_t i = 0; i < particles_.size(); ++i)
    energy.add(particles_.m[i] * gas.P[i] / (gas.rho[i] * gas.rho[i]) * mass_drho[i]);
  return energy;
}

}  // namespace sphk::test
