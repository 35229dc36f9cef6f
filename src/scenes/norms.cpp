#include "src/scenes/norms.hpp"

#include <cmath>

namespace sphk {

namespace {

/// v, rho and P, or their errors.
using Triple = std::array<double, 3>;
constexpr const char* names[] = {"v", "rho", "P"};

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
  Triple sum{};
  double particles = 0;
};

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
  const std::vector<Array3> places = rows(snapshot.field("Coordinates")), v = rows(snapshot.field("Velocities"));
  const auto &rho = snapshot.field("Densities").values, &P = snapshot.field("Pressures").values;
  std::vector<Bin> bins(static_cast<std::size_t>(std::max(std::lround((line.to - line.from) / line.width), 0L)));
  std::array<NormSum, 3> binned, single;
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    const Array3 &x = places[i], direction = line.direction(x);
    const double place = (line.coordinate(x) - line.from) / line.width;
    if (!(place >= 0 && place < double(bins.size()))) continue;
    const Triple value = compared({rho[i], v[i], P[i]}, direction);
    const Triple wanted = compared(exact(x, snapshot.time), direction);
    Bin& bin = bins[static_cast<std::size_t>(place)];
    ++bin.particles;
    for (int k = 0; k < 3; ++k) {
      bin.sum[k] += value[k];
      single[k].add(value[k] - wanted[k], x);
    }
  }
  for (std::size_t b = 0; b < bins.size(); ++b) {
    if (bins[b].particles == 0) continue;
    const Array3 centre{line.from + (double(b) + 0.5) * line.width, 0, 0};
    const Triple wanted = compared(exact(centre, snapshot.time), line.direction(centre));
    for (int k = 0; k < 3; ++k) binned[k].add(bins[b].sum[k] / bins[b].particles - wanted[k], centre);
  }
  Errors errors;
  for (int k = 0; k < 3; ++k) {
    if (single[k].samples == 0) continue;
    errors[names[k]] = binned[k].result();
    errors[std::string(names[k]) + "_particles"] = single[k].result();
  }
  return errors;
}

}  // namespace sphk
