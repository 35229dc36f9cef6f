// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/output.hpp"

#include <fmt/format.h>

#include "src/engine/errors.hpp"

namespace sphk {

Counts counts_of(const StepCounts& steps) {
  const auto& [searches, fits, losses] = steps;
  return {.bisections = searches.bisections,
          .capped = searches.capped,
          .crowded = searches.crowded,
          .failed = searches.failed,
          .linear_fits = fits.linear,
          .sph_estimates = fits.sph,
          .softened_heat = losses.heat,
          .softened_mass = losses.mass};
}

Snapshot Simulation::snapshot() const {
  Snapshot snapshot = view();
  for (Field& field : snapshot.fields) {
    field.fill();
    field.make = {};
  }
  return snapshot;
}

SavedState Simulation::save() const {
  SavedState saved;
  save([&](const std::string& name, std::span<const std::uint8_t> bytes) {
    saved[name].assign(bytes.begin(), bytes.end());
  });
  return saved;
}

void Simulation::restore(const SavedState& saved) {
  restore([&](const std::string& name) {
    const auto found = saved.find(name);
    if (found == saved.end()) throw InputError(fmt::format("the saved state has no \"{}\"", name));
    return found->second;
  });
}

std::vector<std::string> Simulation::warnings() const {
  const Counts c = counts();
  std::vector<std::string> warnings;
  if (c.capped > 0)
    warnings.push_back(
        fmt::format("{} searches ended at the largest support radius with fewer neighbours than asked: raise "
                    "sph.h_max or lower sph.neighbours",
                    c.capped));
  if (c.crowded > 0)
    warnings.push_back(
        fmt::format("{} searches found more coincident particles than neighbours asked: their support holds "
                    "nobody else; `sphk ic check` lists them",
                    c.crowded));
  if (c.failed > 0) warnings.push_back(fmt::format("{} searches for a support radius did not converge", c.failed));
  if (c.linear_fits + c.sph_estimates > 0)
    warnings.push_back(fmt::format(
        "{} fits of the velocity gradients were linear and {} gave way to the SPH estimate: too few neighbours, or on "
        "a line or plane; more of them (sph.neighbours) allow second order",
        c.linear_fits, c.sph_estimates));
  if (c.softened_heat + c.softened_mass > 0)
    warnings.push_back(fmt::format(
        "{} kicks would have taken more than half of a particle's heat and {} of its mass: what was lost beyond that "
        "was softened, so that it stays positive, and is not conserved; a smaller time.courant avoids it",
        c.softened_heat, c.softened_mass));
  return warnings;
}

}  // namespace sphk
