// SPDX-License-Identifier: BSD-3-Clause
#include "tests/engine/brute_force.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "kernels/smoothing/list.hpp"
#include "tests/engine/array3.hpp"

namespace sphk::test {

namespace {

double sphere_volume(int dimension, double h) {
  return dimension == 1 ? 2 * h : dimension == 2 ? M_PI * h * h : 4 * M_PI / 3 * h * h * h;
}

}  // namespace

BruteForce::BruteForce(const ParticleSet& particles, const SimulationSettings& settings)
    : particles_(particles), settings_(settings) {
  const std::size_t size = particles.size();
  for (auto* field : {&h, &rho, &n, &dn_dh, &drho_dh, &P, &c, &balsara, &entropy_rate, &count, &div_v})
    field->assign(size, 0);
  for (auto* field : {&a, &curl_v}) field->assign(size, Array3{});
  const int last = static_cast<int>(size);
  for (int i = 0; i < last; ++i) h[i] = root_of_constraint(i);
  for (int i = 0; i < last; ++i) gather_sums(i);
  for (int i = 0; i < last; ++i) state_equation(i);
  for (int i = 0; i < last; ++i) pair_sums(i);
}

BruteForce::Kernel BruteForce::kernel(double r, double h_of) const {
  const int D = particles_.dimension;
  return with_kernel(settings_.kernel, [&](const auto& k) {
    const double q = r / h_of, norm = k.norm(D) / std::pow(h_of, D);
    const auto shape = k(q), own = with_own_derivative(k, q);
    return Kernel{norm * shape.w, norm / h_of * shape.dw, -norm / h_of * (D * own.w + q * own.dw)};
  });
}

/// Every image of every particle nearer than `reach`.
std::vector<BruteForce::Neighbour> BruteForce::images(int i, double reach) const {
  const Box& box = particles_.box;
  int most[3] = {0, 0, 0};
  for (int d = 0; d < particles_.dimension; ++d)
    if (box.periodic[d]) most[d] = static_cast<int>(std::ceil(reach / box.size[d])) + 1;
  std::vector<Neighbour> found;
  for (int j = 0; j < static_cast<int>(particles_.size()); ++j)
    for (int a_image = -most[0]; a_image <= most[0]; ++a_image)
      for (int b_image = -most[1]; b_image <= most[1]; ++b_image)
        for (int c_image = -most[2]; c_image <= most[2]; ++c_image) {
          Array3 r_ij = difference(particles_.x[i], particles_.x[j]);
          r_ij[0] += a_image * box.size[0], r_ij[1] += b_image * box.size[1], r_ij[2] += c_image * box.size[2];
          const double r = std::sqrt(dot(r_ij, r_ij));
          if (r < reach) found.push_back({j, r_ij, r});
        }
  return found;
}

/// V h^D n(h) = N_n (S12 eq 11) by bisection to the last bit.
double BruteForce::root_of_constraint(int i) const {
  const Box& box = particles_.box;
  const double volume = box.size[0] * box.size[1] * box.size[2] / double(particles_.size());  // unused axes have size 1
  double low = 0, high = std::pow(settings_.neighbours * volume / sphere_volume(particles_.dimension, 1),
                                  1.0 / particles_.dimension);
  std::vector<Neighbour> pairs = images(i, high);
  const auto excess = [&](double trial) {
    double sum = 0;
    for (const Neighbour& pair : pairs)
      if (pair.r < trial) sum += kernel(pair.r, trial).W;
    return sphere_volume(particles_.dimension, trial) * sum - settings_.neighbours;
  };
  while (excess(high) < 0) high *= 1.5, pairs = images(i, high);
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (excess(middle) < 0 ? low : high) = middle;
  }
  return high;
}

void BruteForce::gather_sums(int i) {
  for (const Neighbour& pair : images(i, h[i])) {
    const double m = particles_.m[pair.j];
    const Kernel W = kernel(pair.r, h[i]);
    n[i] += W.W, dn_dh[i] += W.dW_dh;
    rho[i] += m * W.W, drho_dh[i] += m * W.dW_dh;
    count[i] += 1;
    if (pair.r == 0) continue;
    const Array3 v_ij = difference(particles_.v[i], particles_.v[pair.j]);
    Array3 grad{};
    add(grad, W.dW_dr / pair.r, pair.r_ij);
    div_v[i] -= m * dot(v_ij, grad);
    add(curl_v[i], m,
        {v_ij[1] * grad[2] - v_ij[2] * grad[1], v_ij[2] * grad[0] - v_ij[0] * grad[2],
         v_ij[0] * grad[1] - v_ij[1] * grad[0]});
  }
  div_v[i] /= rho[i];
  for (double& component : curl_v[i]) component /= rho[i];
}

void BruteForce::state_equation(int i) {
  P[i] = (settings_.gamma - 1) * rho[i] * particles_.u[i];
  c[i] = std::sqrt(settings_.gamma * P[i] / rho[i]);
  const double div = std::abs(div_v[i]), curl = std::sqrt(dot(curl_v[i], curl_v[i]));
  balsara[i] = div / (div + curl + 1e-4 * c[i] / h[i]);
}

std::vector<BruteForce::Pair> BruteForce::pairs(int i) const {
  const double widest = *std::max_element(h.begin(), h.end());
  std::vector<Pair> found;
  for (const Neighbour& near : images(i, widest)) {
    if (near.r >= std::max(h[i], h[near.j])) continue;
    const Kernel none{0, 0, 0}, own = near.r < h[i] ? kernel(near.r, h[i]) : none,
                                other = near.r < h[near.j] ? kernel(near.r, h[near.j]) : none;
    Pair pair{near.j, {}, near.r, 0.5 * (own.W + other.W), 0, 0, 0};
    if (near.r > 0) {
      add(pair.e, 1 / near.r, near.r_ij);
      pair.dW_i = own.dW_dr, pair.dW_j = other.dW_dr;
      pair.dW = 0.5 * (pair.dW_i + pair.dW_j);
    }
    found.push_back(pair);
  }
  return found;
}

double BruteForce::z(int i) const {
  const double factor = h[i] / (particles_.dimension * n[i]);
  return -factor * drho_dh[i] / (1 + factor * dn_dh[i]);
}

double BruteForce::pressure_force(MomentumForm form, int i, const Pair& pair) const {
  const int j = pair.j;
  const double m_i = particles_.m[i], m_j = particles_.m[j];
  const double P_i = P[i] / (rho[i] * rho[i]), P_j = P[j] / (rho[j] * rho[j]);
  switch (form) {
    case MomentumForm::sph:
      return -m_j * (P_i + P_j) * pair.dW;
    case MomentumForm::tsph:
      return -m_j * (P[i] + P[j]) / (rho[i] * rho[j]) * pair.dW;
    case MomentumForm::conservative:
      return -(P_i * (m_j + z(i)) * pair.dW_i + m_j / m_i * P_j * (m_i + z(j)) * pair.dW_j);
    case MomentumForm::morris:
      return -m_j * (P[j] - P[i]) / (rho[i] * rho[j]) * pair.dW;
  }
  throw std::logic_error("no such form of the pressure force");
}

void BruteForce::pair_sums(int i) {
  const double gamma = settings_.gamma, alpha = settings_.numbers.value_or("viscosity.alpha", 1),
               beta = settings_.numbers.value_or("viscosity.beta", 2);
  const bool gadget2 = settings_.scheme == "gadget2";
  const MomentumForm form = gadget2                     ? MomentumForm::conservative
                            : settings_.scheme == "sph" ? MomentumForm::sph
                                                        : MomentumForm::tsph;
  double heating = 0;
  for (const Pair& pair : pairs(i)) {
    const int j = pair.j;
    if (pair.r == 0) continue;
    const double m = particles_.m[j], w = dot(difference(particles_.v[i], particles_.v[j]), pair.e);
    add(a[i], pressure_force(form, i, pair), pair.e);
    double Pi = 0;
    if (w < 0 && gadget2) {
      Pi = -0.5 * alpha * (c[i] + c[j] - 3 * w) * w / (0.5 * (rho[i] + rho[j]));
    } else if (w < 0) {
      const double hs = 0.5 * (0.5 * (h[i] + h[j])), mu = hs * w * pair.r / (pair.r * pair.r + 0.01 * hs * hs);
      Pi = (-alpha * 0.5 * (c[i] + c[j]) * mu + beta * mu * mu) / (0.5 * (rho[i] + rho[j]));
    }
    Pi *= 0.5 * (balsara[i] + balsara[j]);
    add(a[i], -m * Pi * pair.dW, pair.e);
    heating += 0.5 * m * Pi * w * pair.dW;
  }
  entropy_rate[i] = (gamma - 1) * std::pow(rho[i], 1 - gamma) * heating;
}

ParticleSet shaken_lattice(int dimension, Array3 counts, double jitter, bool periodic, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int d = dimension; d < 3; ++d) counts[d] = 1;
  ParticleSet particles;
  particles.dimension = dimension;
  const double spacing = 1 / counts[0];
  for (int d = 0; d < dimension; ++d) {
    particles.box.lower[d] = -0.25;
    particles.box.size[d] = counts[d] * spacing;
    particles.box.periodic[d] = periodic;
  }
  for (int k = 0; k < counts[0] * counts[1] * counts[2]; ++k) {
    const int index[3] = {k % int(counts[0]), k / int(counts[0]) % int(counts[1]), k / int(counts[0] * counts[1])};
    Array3 x{}, v{};
    for (int d = 0; d < dimension; ++d) {
      x[d] = particles.box.lower[d] + (index[d] + 0.5 + jitter * unit(engine)) * spacing;
      v[d] = unit(engine);
    }
    particles.x.push_back(x);
    particles.v.push_back(v);
    particles.m.push_back((1 + 0.3 * unit(engine)) * std::pow(spacing, dimension));
    particles.u.push_back(1 + 0.5 * unit(engine));
  }
  return particles;
}

}  // namespace sphk::test
