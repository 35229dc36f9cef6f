// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/error_budget.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace sphk {

namespace {

const std::vector<double>& values_of(const std::vector<Field>& fields, const std::string& name) {
  const auto field = std::ranges::find(fields, name, &Field::name);
  if (field == fields.end()) throw std::out_of_range("no field " + name + " among the errors");
  return field->values;
}

double mean_of(const std::vector<double>& values) {
  return values.empty() ? 0 : std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

/// The value that this fraction of `values` does not exceed.
double percentile(std::vector<double> values, double fraction) {
  if (values.empty()) return 0;
  const auto place = values.begin() + std::ptrdiff_t(fraction * double(values.size() - 1) + 0.5);
  std::ranges::nth_element(values, place);
  return *place;
}

ErrorShare share_of(const std::vector<double>& E0) {
  return {E0.size(), mean_of(E0), percentile(E0, 0.95), E0.empty() ? 0 : std::ranges::max(E0)};
}

/// Mean |M - 1| of symmetric matrices xx, yy, zz, xy, xz, yz.
double distance_from_one(const std::vector<double>& M, int dimension) {
  double sum = 0;
  const std::size_t n = M.size() / 6;
  for (std::size_t i = 0; i < n; ++i) {
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) square += std::pow(M[6 * i + k] - (int(k) < dimension ? 1 : 0), 2);
    for (std::size_t k = 3; k < 6; ++k) square += 2 * std::pow(M[6 * i + k], 2);
    sum += std::sqrt(square);
  }
  return n > 0 ? sum / double(n) : 0;
}

/// Mean |epsilon| over mean |rho div v|: how much of the change of density is none that the equations have.
double share_of_compression(const std::vector<double>& epsilon, const Snapshot& snapshot) {
  if (!snapshot.has("VelocityDivergence")) return 0;
  const auto &div_v = snapshot.field("VelocityDivergence").values, &rho = snapshot.field("Densities").values;
  double residual = 0, compression = 0;
  for (std::size_t i = 0; i < epsilon.size(); ++i)
    residual += std::abs(epsilon[i]), compression += std::abs(rho[i] * div_v[i]);
  return compression > 0 ? residual / compression : 0;
}

}  // namespace

ErrorBudget error_budget(const Snapshot& snapshot, const std::vector<Field>& errors) {
  const auto &E0 = values_of(errors, "E0"), &contrast = values_of(errors, "EntropyContrast"),
             &distance = values_of(errors, "NearestNeighbour");
  const auto &m = snapshot.field("Masses").values, &rho = snapshot.field("Densities").values;
  std::vector<double> all, boundary, bulk, nearest;
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    all.push_back(std::hypot(E0[3 * i], E0[3 * i + 1], E0[3 * i + 2]));
    (contrast[i] > std::log(boundary_contrast) ? boundary : bulk).push_back(all.back());
    if (distance[i] > 0) nearest.push_back(distance[i] / std::pow(m[i] / rho[i], 1.0 / snapshot.dimension));
  }
  return {.all = share_of(all),
          .boundary = share_of(boundary),
          .bulk = share_of(bulk),
          .R = distance_from_one(values_of(errors, "R"), snapshot.dimension),
          .V = distance_from_one(values_of(errors, "V"), snapshot.dimension),
          .epsilon = share_of_compression(values_of(errors, "Epsilon"), snapshot),
          .nearest = mean_of(nearest),
          .nearest_low = percentile(nearest, 0.05)};
}

std::vector<std::pair<std::string, double>> columns(const ErrorBudget& b) {
  const auto mean = [](const ErrorShare& share) {
    return share.particles > 0 ? share.mean : std::numeric_limits<double>::quiet_NaN();
  };
  return {{"E0_mean", b.all.mean},
          {"E0_95", b.all.high},
          {"E0_max", b.all.max},
          {"E0_boundary", mean(b.boundary)},
          {"E0_bulk", mean(b.bulk)},
          {"R_error", b.R},
          {"V_error", b.V},
          {"epsilon_share", b.epsilon},
          {"nearest_mean", b.nearest},
          {"nearest_5", b.nearest_low}};
}

}  // namespace sphk
