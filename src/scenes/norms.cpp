// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/norms.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace sphk {

namespace {

/// v, rho and P, or their errors.
using Triple = std::array<double, 3>;
constexpr const char* names[] = {"v", "rho", "P"};

/// How an error is taken: what its name has behind v, rho or P, and what it is the mean of.
struct Kind {
  const char *suffix, *meaning;
};
constexpr Kind kinds[] = {
    {"", "over bins of the distance between the means of the particles and of the exact solution at their places"},
    {"_centres", "over bins of the distance between the particles' mean and the exact solution at the bin's centre"},
    {"_particles", "over particles of the distance from the exact solution at their places"}};

/// Sums one error after the other into a norm.
struct NormSum {
  ErrorNorm norm;
  double samples = 0;

  void add(double error, const Array3& x) {
    error = std::abs(error);
    norm.l1 += error;
    norm.l2 += error * error;
    ++samples;
    if (error > norm.linf || std::isnan(error)) norm.linf = error, norm.where = x;
  }
  ErrorNorm result() const {
    ErrorNorm mean = norm;
    mean.l1 = norm.l1 / samples;
    mean.l2 = std::sqrt(norm.l2 / samples);
    return mean;
  }
};

struct Bin {
  Triple sum{}, exact{};
  double particles = 0;

  void add(const Triple& value, const Triple& wanted) {
    ++particles;
    for (int k = 0; k < 3; ++k) sum[k] += value[k], exact[k] += wanted[k];
  }
};

/// An error norm of each of v, rho and P.
using Norms = std::array<NormSum, 3>;

Triple compared(const GasState& state, const Array3& direction) {
  return {dot(state.v, direction), state.rho, state.P};
}

}  // namespace

double dot(const Array3& a, const Array3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double radius(const Array3& x) {
  return std::sqrt(dot(x, x));
}

ProfileLine along_x(double from, double to) {
  return {[](const Array3& x) { return x[0]; }, [](const Array3&) { return Array3{1, 0, 0}; }, from, to};
}

ProfileLine along_r(double to) {
  const auto outwards = [](const Array3& x) {
    const double distance = radius(x);
    return distance > 0 ? Array3{x[0] / distance, x[1] / distance, x[2] / distance} : Array3{};
  };
  return {radius, outwards, 0, to};
}

ProfileLine along_R(double to) {
  const auto R = [](const Array3& x) { return std::hypot(x[0], x[1]); };
  const auto around = [R](const Array3& x) {
    const double distance = R(x);
    return distance > 0 ? Array3{-x[1] / distance, x[0] / distance, 0} : Array3{};
  };
  return {R, around, 0, to};
}

Errors profile_errors(const Snapshot& snapshot, const ProfileLine& line, const ExactSolution& exact) {
  const auto places = rows(snapshot.field("Coordinates")), v = rows(snapshot.field("Velocities"));
  const auto &rho = snapshot.field("Densities").values, &P = snapshot.field("Pressures").values;
  std::vector<Bin> bins(static_cast<std::size_t>(std::max(std::lround((line.to - line.from) / line.width), 0L)));
  std::array<Norms, std::size(kinds)> all;
  auto& [binned, centred, single] = all;
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    const Array3 &x = places[i], direction = line.direction(x);
    const double place = (line.coordinate(x) - line.from) / line.width;
    if (!(place >= 0 && place < double(bins.size()))) continue;
    const Triple value = compared({rho[i], v[i], P[i]}, direction);
    const Triple wanted = compared(exact(x, snapshot.time), direction);
    bins[static_cast<std::size_t>(place)].add(value, wanted);
    for (int k = 0; k < 3; ++k) single[k].add(value[k] - wanted[k], x);
  }
  for (std::size_t b = 0; b < bins.size(); ++b) {
    const Bin& bin = bins[b];
    if (bin.particles == 0) continue;
    const Array3 centre{line.from + (double(b) + 0.5) * line.width, 0, 0};
    const Triple there = compared(exact(centre, snapshot.time), line.direction(centre));
    for (int k = 0; k < 3; ++k) {
      binned[k].add((bin.sum[k] - bin.exact[k]) / bin.particles, centre);
      centred[k].add(bin.sum[k] / bin.particles - there[k], centre);
    }
  }
  Errors errors;
  const Norms* norms = all.data();
  for (const auto& [suffix, meaning] : kinds) {
    for (int k = 0; k < 3; ++k)
      if ((*norms)[k].samples > 0) errors[std::string(names[k]) + suffix] = (*norms)[k].result();
    ++norms;
  }
  return errors;
}

std::string meaning_of_error(const std::string& name) {
  for (const auto& [suffix, meaning] : kinds)
    for (const std::string field : names)
      if (name == field + suffix) return meaning;
  return "";
}

}  // namespace sphk
