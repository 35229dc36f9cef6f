// SPDX-License-Identifier: BSD-3-Clause
#include "src/schemes/checks.hpp"

#include <fmt/format.h>

#include <cmath>

#include "kernels/passes/central_mass.hpp"
#include "src/engine/errors.hpp"

namespace sphk {

namespace {

void check_lengths(const ParticleSet& p) {
  const std::size_t n = p.size();
  const auto check = [&](std::size_t length, const char* what, bool optional) {
    if (length == n || (optional && length == 0)) return;
    throw InputError(fmt::format("the initial condition has {} positions but {} {}", n, length, what));
  };
  if (n == 0) throw InputError("the initial condition has no gas particles: at least one is needed");
  if (n > 2000000000) throw InputError(fmt::format("{} particles are more than one process can index (2e9)", n));
  check(p.v.size(), "velocities", false);
  check(p.m.size(), "masses", false);
  check(p.u.size(), "thermal energies", false);
  check(p.h.size(), "smoothing lengths", true);
  check(p.alpha.size(), "values of alpha", true);
  check(p.id.size(), "ids", true);
}

void fail(const ParticleSet& p, std::size_t i, const std::string& what, const char* remedy) {
  const std::uint64_t id = p.id.empty() ? i + 1 : p.id[i];
  throw InputError(
      fmt::format("particle {} (id {}) at ({}, {}, {}): {}; {}", i, id, p.x[i][0], p.x[i][1], p.x[i][2], what, remedy));
}

}  // namespace

void check_runnable(const ParticleSet& p) {
  if (p.dimension < 1 || p.dimension > 3) throw InputError(fmt::format("dimension {} is not 1, 2 or 3", p.dimension));
  check_lengths(p);
  for (int d = 0; d < p.dimension; ++d)
    if (!(p.box.size[d] > 0 && std::isfinite(p.box.size[d])))
      throw InputError(fmt::format("the box has size {} along axis {}: it must be positive", p.box.size[d], d));
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (int d = 0; d < p.dimension; ++d) {
      if (!std::isfinite(p.x[i][d])) fail(p, i, fmt::format("its position is {}", p.x[i][d]), "give a finite one");
      if (!std::isfinite(p.v[i][d])) fail(p, i, fmt::format("its velocity is {}", p.v[i][d]), "give a finite one");
    }
    if (!(p.m[i] > 0 && std::isfinite(p.m[i])))
      fail(p, i, fmt::format("its mass is {}", p.m[i]), "masses must be positive");
    if (!(p.u[i] >= 0 && std::isfinite(p.u[i])))
      fail(p, i, fmt::format("its specific energy is {}", p.u[i]), "it must be zero or positive");
    if (!p.h.empty() && !(p.h[i] >= 0 && std::isfinite(p.h[i])))
      fail(p, i, fmt::format("its smoothing length is {}", p.h[i]), "give a positive one, or 0 to have it found");
  }
}

void check_runnable(const SimulationSettings& s, const ParticleSet& particles, double least) {
  const int dimension = particles.dimension;
  if (!(s.neighbours > least))
    throw InputError(fmt::format(
        "sph.neighbours = {}: kernel {} in {}D counts {:.4g} for the particle itself, so no support radius gives "
        "fewer; ask for more than that",
        s.neighbours, s.kernel, dimension, least));
  if (!(s.gamma > 1)) throw InputError(fmt::format("sph.gamma = {}: it must be above 1", s.gamma));
  if (!(s.courant > 0)) throw InputError(fmt::format("time.courant = {}: it must be positive", s.courant));
  const double mass = s.numbers[central_mass];
  for (int d = 0; d < dimension; ++d)
    if (mass > 0 && particles.box.periodic[d])
      throw InputError(
          fmt::format("gravity.central_mass = {}: the box is periodic along {}, and images of the central mass would "
                      "pull as well; take an open box, or no central mass",
                      mass, "xyz"[d]));
}

}  // namespace sphk
