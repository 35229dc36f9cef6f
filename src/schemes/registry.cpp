#include "src/schemes/registry.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "kernels/passes/support_search.hpp"
#include "kernels/smoothing/list.hpp"
#include "src/engine/errors.hpp"
#include "src/schemes/checks.hpp"
#include "src/schemes/instantiation.hpp"

namespace sphk {

namespace {

const Instantiations& table() {
  static const Instantiations all = [] {
    Instantiations rows;
    for (const auto source : {sph_entropy_1d, sph_entropy_2d, sph_entropy_3d, sph_energy_1d, sph_energy_2d,
                              sph_energy_3d, tsph_1d, tsph_2d, tsph_3d, gadget2_1d, gadget2_2d, gadget2_3d, glass})
      for (Instantiation& row : source()) rows.push_back(std::move(row));
    return rows;
  }();
  return all;
}

/// The compiled scheme for these settings: the kernel's own instantiation, or the table's.
const Instantiation& choose(const SimulationSettings& settings, int dimension) {
  const auto matches = [&](const Instantiation& row, const std::string& kernel) {
    return row.scheme == settings.scheme && row.energy == settings.energy && row.dimension == dimension &&
           row.precision == settings.precision && row.kernel == kernel;
  };
  for (const std::string& kernel : {settings.kernel, std::string()})
    for (const Instantiation& row : table())
      if (matches(row, kernel)) return row;
  throw InputError(
      fmt::format("there is no scheme \"{}\" that integrates \"{}\" in {}D with \"{}\" precision; schemes are {}",
                  settings.scheme, settings.energy, dimension, settings.precision, fmt::join(scheme_names(), ", ")));
}

/// R10's Courant number for its time-step condition, S12's for that of the signal-velocity viscosity.
double usual_courant(const std::string& scheme) {
  return scheme == "gadget2" ? 0.2 : 0.4;
}

double with_kernel_number(const std::string& kernel, double (*number)(double w0, double norm, int dimension),
                          int dimension) {
  try {
    return with_kernel(kernel, [&](const auto& k) { return number(k.w(0.0), k.norm(dimension), dimension); });
  } catch (const std::invalid_argument& error) {
    throw InputError(std::string("sph.kernel: ") + error.what());
  }
}

}  // namespace

std::vector<std::string> scheme_names() {
  std::vector<std::string> names;
  for (const Instantiation& row : table())
    if (row.scheme != "glass" && std::ranges::find(names, row.scheme) == names.end()) names.push_back(row.scheme);
  return names;
}

std::vector<std::string> kernel_names() {
  return smoothing_kernel_names();
}

double min_neighbours(const std::string& kernel, int dimension) {
  const auto self_term = [](double w0, double norm, int d) {
    return (d == 1 ? unit_sphere<1> : d == 2 ? unit_sphere<2> : unit_sphere<3>)*norm * w0;
  };
  return with_kernel_number(kernel, self_term, dimension);
}

void declare_engine_keys(Settings& settings) {
  settings.declare({"sph.scheme", "sph", "method of the momentum equation", scheme_names()});
  settings.declare({"sph.kernel", "cs", "smoothing kernel; liq takes its core edge, as in liq0.4", {}});
  settings.declare({"sph.neighbours", 48.0, "neighbour number N_n of V_D h^D n = N_n", {}, 1, 1e6});
  settings.declare(
      {"sph.precision", "mixed", "pair arithmetic: float with double state and sums, or double", {"mixed", "double"}});
  settings.declare({"sph.energy", "entropy", "integrated thermal variable", {"entropy", "energy"}});
  settings.declare({"sph.gamma", 5.0 / 3, "adiabatic index", {}, 1.0000001, 100});
  settings.declare({"sph.h_max",
                    0.0,
                    "largest support radius; 0: the diagonal of an open box, no limit that matters in a periodic one",
                    {},
                    0,
                    1e300});
  settings.declare({"viscosity.alpha", 1.0, "linear viscosity", {}, 0, 100});
  settings.declare({"viscosity.beta", 2.0, "quadratic viscosity (schemes sph and tsph)", {}, 0, 100});
  settings.declare({"time.courant",
                    0.0,
                    "C of dt = C h / v_max; 0: the scheme's own, 0.4 for sph and tsph, 0.2 for gadget2",
                    {},
                    0,
                    10});
  settings.declare({"time.max_dt", 0.0, "largest time-step; 0: no limit", {}, 0, 1e300});
}

SimulationSettings simulation_settings(const Settings& settings) {
  return {.scheme = settings.text("sph.scheme"),
          .kernel = settings.text("sph.kernel"),
          .precision = settings.text("sph.precision"),
          .energy = settings.text("sph.energy"),
          .neighbours = settings.real("sph.neighbours"),
          .gamma = settings.real("sph.gamma"),
          .courant = settings.real("time.courant") > 0 ? settings.real("time.courant")
                                                       : usual_courant(settings.text("sph.scheme")),
          .viscosity_alpha = settings.real("viscosity.alpha"),
          .viscosity_beta = settings.real("viscosity.beta"),
          .h_max = settings.real("sph.h_max"),
          .max_dt = settings.real("time.max_dt")};
}

SchemeDescription describe(const SimulationSettings& settings, int dimension) {
  const Instantiation& row = choose(settings, dimension);
  SchemeDescription description = row.describe();
  description.scheme = settings.scheme;
  description.kernel = settings.kernel;
  description.tabulated = row.kernel.empty();
  return description;
}

std::unique_ptr<Simulation> make_simulation(const ParticleSet& particles, const SimulationSettings& settings) {
  check_runnable(particles);
  check_runnable(settings, particles.dimension);
  return choose(settings, particles.dimension).make(particles, settings);
}

}  // namespace sphk
