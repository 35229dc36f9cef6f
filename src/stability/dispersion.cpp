// SPDX-License-Identifier: BSD-3-Clause
#include "src/stability/dispersion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernels/smoothing/list.hpp"
#include "src/engine/errors.hpp"
#include "src/engine/geometry.hpp"

namespace sphk {

namespace {

using Complex = std::complex<double>;

/// A cell of the given edges (units beyond the dimension) and basis (in units of the edges), scaled to one particle in
/// a unit of volume.
Lattice scaled(const std::string& name, int dimension, std::array<Array3, 3> edges, const std::vector<Array3>& basis) {
  const double volume =
      std::abs(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(edges[0].data()).determinant());
  const double scale = std::pow(static_cast<double>(basis.size()) / volume, 1.0 / dimension);
  Lattice lattice{.name = name, .dimension = dimension, .edges = edges, .basis = {}};
  for (Array3& edge : lattice.edges)
    for (double& x : edge) x *= scale;
  for (const Array3& b : basis) {
    Array3 x{};
    for (int a = 0; a < dimension; ++a)
      for (int d = 0; d < dimension; ++d) x[d] += b[a] * lattice.edges[a][d];
    lattice.basis.push_back(x);
  }
  return lattice;
}

double dot(const Array3& a, const Array3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// w'' by differences of w', which the kernels have in closed form; pieces of polynomials, so the error is that of
/// rounding but at their joints, where this is the mean of both sides.
double second_derivative(const auto& kernel, double q) {
  const double step = 1e-5;
  const auto slope = [&](double s) { return (kernel(q + s).dw - kernel(q - s).dw) / (2 * s); };
  return (4 * slope(step) - slope(2 * step)) / 3;
}

/// The modes of a matrix whose eigenvalues are omega^2/(k^2 c^2), rows by site and component, told apart by how they
/// move.
WaveModes modes_of(const Eigen::MatrixXcd& matrix, const Array3& k, int dimension) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> waves(matrix);
  const auto size = static_cast<int>(matrix.rows()), sites = size / dimension;
  const bool upwards = k[0] == 0 && k[1] == 0;
  const Array3 in_plane = upwards ? Array3{0, 1, 0} : Array3{k[1], -k[0], 0};  // across k
  WaveModes modes;
  for (int n = 0; n < size; ++n) {  // eigenvalues rise
    std::array<Complex, 3> sum{};   // of all sites
    for (int i = 0; i < size; ++i) sum[i % dimension] += waves.eigenvectors()(i, n);
    const auto share = [&](const Array3& way) {
      return std::norm(way[0] * sum[0] + way[1] * sum[1] + way[2] * sum[2]) / dot(way, way);
    };
    const double all = std::norm(sum[0]) + std::norm(sum[1]) + std::norm(sum[2]), along = share(k);
    double& mode = all < 0.5 * sites                       ? modes.relative
                   : along > 0.5 * all                     ? modes.longitudinal
                   : share(in_plane) > 0.5 * (all - along) ? modes.transverse
                                                           : modes.transverse_z;
    if (std::isnan(mode)) mode = waves.eigenvalues()(n);
  }
  return modes;
}

}  // namespace

const std::vector<Lattice>& lattices() {
  const double up = std::sqrt(0.75), high = std::sqrt(8.0 / 3);
  static const std::vector<Lattice> all{
      scaled("cubic", 3, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {{0, 0, 0}}),
      scaled("bcc", 3, {{{-1, 1, 1}, {1, -1, 1}, {1, 1, -1}}}, {{0, 0, 0}}),
      scaled("fcc", 3, {{{0, 1, 1}, {1, 0, 1}, {1, 1, 0}}}, {{0, 0, 0}}),
      scaled("hcp", 3, {{{1, 0, 0}, {0.5, up, 0}, {0, 0, high}}}, {{0, 0, 0}, {1.0 / 3, 1.0 / 3, 0.5}}),
      scaled("square", 2, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {{0, 0, 0}}),
      scaled("hexagonal", 2, {{{1, 0, 0}, {0.5, up, 0}, {0, 0, 1}}}, {{0, 0, 0}}),
      scaled("line", 1, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {{0, 0, 0}})};
  return all;
}

const Lattice& find_lattice(const std::string& name) {
  const auto found = std::ranges::find(lattices(), name, &Lattice::name);
  if (found != lattices().end()) return *found;
  std::vector<std::string> names;
  for (const Lattice& lattice : lattices()) names.push_back(lattice.name);
  throw InputError(fmt::format("there is no lattice \"{}\"; known are {}", name, fmt::join(names, ", ")));
}

WaveModes slower(const WaveModes& a, const WaveModes& b) {
  return {std::fmin(a.longitudinal, b.longitudinal), std::fmin(a.transverse, b.transverse),
          std::fmin(a.transverse_z, b.transverse_z), std::fmin(a.relative, b.relative)};
}

Dispersion::Dispersion(const Lattice& lattice, const std::string& kernel, double h, double gamma)
    : dimension_(lattice.dimension), sites_(static_cast<int>(lattice.basis.size())), gamma_(gamma), rho_(0) {
  const int D = dimension_, reach = static_cast<int>(std::ceil(2 * h)) + 2;
  with_kernel(kernel, [&](const auto& shape) {
    const double norm = shape.norm(D) / std::pow(h, D), force_norm = norm_of_forces(shape, D) / std::pow(h, D);
    const std::array<int, 3> cells{reach, D > 1 ? reach : 0, D > 2 ? reach : 0};
    rho_ = norm * shape(0.0).w;
    for (int of = 0; of < sites_; ++of)
      for (int site = 0; site < sites_; ++site)
        for (int a = -cells[0]; a <= cells[0]; ++a)
          for (int b = -cells[1]; b <= cells[1]; ++b)
            for (int c = -cells[2]; c <= cells[2]; ++c) {
              Array3 x{};  // x_i - x_j
              for (int d = 0; d < D; ++d)
                x[d] = lattice.basis[of][d] - lattice.basis[site][d] - a * lattice.edges[0][d] -
                       b * lattice.edges[1][d] - c * lattice.edges[2][d];
              const double r = std::sqrt(dot(x, x)), q = r / h;
              if (r < 1e-9 || q >= 1) continue;
              if (of == 0) rho_ += norm * shape(q).w;
              const double slope = force_norm / h * shape(q).dw,
                           curvature = force_norm / (h * h) * second_derivative(shape, q),
                           density_slope = norm / h * with_own_derivative(shape, q).dw;
              Pair pair{.of = of, .site = site, .x = x, .grad = {}, .grad_density = {}, .hessian = {}};
              for (int d = 0; d < D; ++d) {
                pair.grad[d] = slope * x[d] / r;
                pair.grad_density[d] = density_slope * x[d] / r;
                for (int e = 0; e < D; ++e)
                  pair.hessian[d][e] =
                      curvature * x[d] * x[e] / (r * r) + slope / r * ((d == e) - x[d] * x[e] / (r * r));
              }
              pairs_.push_back(pair);
            }
    return 0;
  });
}

WaveModes Dispersion::at(const Array3& k) const {
  // With m = P_0 = 1: omega^2 a_s = 2/rho^2 sum_t H_st (a_s - a_t e^(-ik.x)) - (gamma - 2)/rho^3 sum_t g_st sum_u g_tu
  // . a_u, g_st = sum e^(-ik.x) grad W over the pairs of sites s and t, the latter with the gradient of the density.
  // Here times rho^2. Where the two gradients differ and are not parallel, the matrix is taken by its Hermitian part.
  const int D = dimension_, size = D * sites_;
  Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Zero(size, size), g = Eigen::MatrixXcd::Zero(size, sites_);
  Eigen::MatrixXcd change = Eigen::MatrixXcd::Zero(sites_, size);  // of the density of site t: -sum_u g_tu . a_u
  for (const Pair& pair : pairs_) {
    const Complex phase = std::polar(1.0, -dot(k, pair.x));
    const int i = D * pair.of, j = D * pair.site;
    for (int d = 0; d < D; ++d) {
      g(i + d, pair.site) += phase * pair.grad[d];
      change(pair.of, j + d) -= phase * pair.grad_density[d];
      for (int e = 0; e < D; ++e) {
        matrix(i + d, i + e) += 2 * pair.hessian[d][e];
        matrix(i + d, j + e) -= 2.0 * phase * pair.hessian[d][e];
      }
    }
  }
  const Eigen::MatrixXcd by_density = (gamma_ - 2) / rho_ * g * change;
  matrix += 0.5 * (by_density + by_density.adjoint());
  return modes_of(matrix / (rho_ * dot(k, k) * gamma_), k, D);
}

std::vector<WaveDirection> wave_directions(int dimension) {
  if (dimension == 1) return {{"(1)", {1, 0, 0}}};
  if (dimension == 2) return {{"(1,0)", {1, 0, 0}}, {"(1,1)", {1, 1, 0}}};
  return {{"(1,0,0)", {1, 0, 0}}, {"(1,1,0)", {1, 1, 0}}, {"(1,1,1)", {1, 1, 1}}};
}

WaveModes slowest_waves(const Dispersion& dispersion, const Array3& direction, int samples) {
  WaveModes slowest;
  for (int n = 1; n <= samples; ++n) {
    const double kappa = std::numbers::pi * n / samples;
    slowest = slower(slowest, dispersion.at({kappa * direction[0], kappa * direction[1], kappa * direction[2]}));
  }
  return slowest;
}

double lattice_support(double neighbours, int dimension) {
  return std::pow(neighbours / unit_sphere_volume(dimension), 1.0 / dimension);
}

double lattice_neighbours(double h, int dimension) {
  return unit_sphere_volume(dimension) * std::pow(h, dimension);
}

WaveModes least_waves(const Lattice& lattice, const std::string& kernel, double h, double gamma, int samples) {
  const Dispersion dispersion(lattice, kernel, h, gamma);
  WaveModes least;
  for (const WaveDirection& direction : wave_directions(lattice.dimension))
    least = slower(least, slowest_waves(dispersion, direction.k, samples));
  return least;
}

}  // namespace sphk
