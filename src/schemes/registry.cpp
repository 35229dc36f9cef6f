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
    for (const auto source : {sph_entropy_1d,
                              sph_entropy_2d,
                              sph_entropy_3d,
                              sph_energy_1d,
                              sph_energy_2d,
                              sph_energy_3d,
                              tsph_1d,
                              tsph_2d,
                              tsph_3d,
                              tsph_energy,
                              osph_1d,
                              osph_2d,
                              osph_3d,
                              osph_energy,
                              osph_coherent,
                              v10_1d,
                              v10_2d,
                              v10_3d,
                              gadget2_1d,
                              gadget2_2d,
                              gadget2_3d,
                              sphs_1d,
                              sphs_2d,
                              sphs_3d,
                              sphs_multi_1d,
                              sphs_multi_2d,
                              sphs_multi_3d,
                              sphs_energy_1d,
                              sphs_energy_2d,
                              sphs_energy_3d,
                              sphs_energy_multi_1d,
                              sphs_energy_multi_2d,
                              sphs_energy_multi_3d,
                              sphs_conservative_1d,
                              sphs_conservative_2d,
                              sphs_conservative_3d,
                              sphs_rt,
                              glass})
      for (Instantiation& row : source()) {
        rows.push_back(row);
        if (row.scheme != "sphs" || row.energy != "entropy") continue;
        row.scheme = "sphs-morris";  // the same code with another number
        rows.push_back(row);
      }
    return rows;
  }();
  return all;
}

/// Schemes that stand behind a user's choice of another, or that scenes use.
constexpr const char* inner_schemes[] = {"glass", "relaxation", "v10-plain", "v10-smoothed"};

/// The table's name of what the settings ask for: without conductivity its term is left out, its second signal velocity
/// needs a pass of its own.
std::string compiled_name(const SimulationSettings& settings) {
  if (settings.scheme != "v10") return settings.scheme;
  return settings.alpha_conductivity == 0 ? "v10-plain" : settings.conductivity == "v2" ? "v10-smoothed" : "v10";
}

/// The compiled scheme for these settings: the kernel's own instantiation, or the table's; one for equal masses where
/// they are equal, or where no mass is to be exchanged.
const Instantiation& choose(const SimulationSettings& settings, int dimension, bool equal_masses) {
  const bool no_exchange = equal_masses || settings.alpha_mass == 0;
  const std::string scheme = compiled_name(settings);
  const auto matches = [&](const Instantiation& row, const std::string& kernel) {
    return row.scheme == scheme && row.energy == settings.energy && row.dimension == dimension &&
           row.precision == settings.precision && row.kernel == kernel;
  };
  for (const std::string& kernel : {settings.kernel, std::string()})
    for (const Masses masses : {Masses::equal, Masses::any})
      for (const Instantiation& row : table())
        if (matches(row, kernel) && row.masses == masses && (masses == Masses::any || no_exchange)) return row;
  throw InputError(
      fmt::format("there is no scheme \"{}\" that integrates \"{}\" in {}D with \"{}\" precision; schemes are {}",
                  settings.scheme, settings.energy, dimension, settings.precision, fmt::join(scheme_names(), ", ")));
}

bool is_of_r10(const std::string& scheme) {
  return scheme == "sph" || scheme == "tsph" || scheme.starts_with("osph");
}

/// R10's Courant number for its time-step condition, S12's for that of the signal-velocity viscosity.
double usual_courant(const std::string& scheme) {
  return is_of_r10(scheme) ? 0.4 : 0.2;
}

/// R10's and V10's coefficient of the quadratic viscosity.
double usual_beta(const std::string& scheme) {
  return scheme == "v10" ? 1.5 : 2;
}

bool have_equal_masses(const ParticleSet& particles) {
  return std::ranges::adjacent_find(particles.m, std::ranges::not_equal_to{}) == particles.m.end();
}

constexpr std::pair<const char*, MassCorrection> mass_corrections[] = {{"donor", MassCorrection::donor},
                                                                       {"donor-unpaid", MassCorrection::donor_unpaid},
                                                                       {"flux", MassCorrection::flux},
                                                                       {"particle", MassCorrection::particle}};

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
    if (std::ranges::find(inner_schemes, row.scheme) == std::end(inner_schemes) &&
        std::ranges::find(names, row.scheme) == names.end())
      names.push_back(row.scheme);
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
  settings.declare({"viscosity.beta",
                    -1.0,
                    "quadratic viscosity (sph, tsph, osph, v10); negative: the scheme's own, 2, or 1.5 for v10",
                    {},
                    -1,
                    100});
  settings.declare({"viscosity.balsara", true, "Balsara's factor limits the viscosity of classic schemes", {}});
  settings.declare({"conductivity.alpha", 1.0, "alpha_u of artificial conductivity (v10)", {}, 0, 100});
  settings.declare({"conductivity.signal",
                    "price",
                    "its signal velocity: Price 2008, or V10's with the sign of dP du (v1), of smoothed pressures (v2)",
                    {"price", "v1", "v2"}});
  settings.declare({"dissipation.entropy", 1.0, "alpha_A of entropy dissipation (sphs)", {}, 0, 100});
  settings.declare({"dissipation.mass", 1.0, "alpha_m of mass dissipation, where masses differ (sphs)", {}, 0, 100});
  std::vector<std::string> forms;
  for (const auto& [name, form] : mass_corrections) forms.emplace_back(name);
  settings.declare(
      {"dissipation.mass_form", "donor",
       "what exchanged mass brings along: the donor's velocity and energy, App. E's flux, or nothing (S12)", forms});
  settings.declare({"switch.alpha", -1.0, "alpha of all particles; negative: the switch decides (sphs)", {}, -1, 100});
  settings.declare({"switch.alpha_min", 0.2, "what alpha decays to (S12 eq 23)", {}, 0, 1});
  settings.declare({"switch.noise", 0.05, "n_s of S12 eq 21", {}, 0, 100});
  settings.declare({"switch.balsara", "all", "which dissipations Balsara's factor limits", {"all", "viscosity"}});
  settings.declare({"time.steps",
                    "auto",
                    "individual steps of the particles in powers of two, or a global one; auto: individual for sphs",
                    {"auto", "individual", "global"}});
  settings.declare(
      {"time.limiter",
       true,
       "keep the steps of neighbours within a factor 4 (Saitoh & Makino 2009), and begin with one step for all",
       {}});
  settings.declare({"time.courant",
                    0.0,
                    "C of dt = C h / v_max; 0: the scheme's own, 0.4 for sph, tsph and osph, 0.2 for the others",
                    {},
                    0,
                    10});
  settings.declare(
      {"time.motion", true, "false: particles keep their places and velocities and only exchange heat and mass", {}});
  settings.declare({"time.max_dt", 0.0, "largest time-step; 0: no limit", {}, 0, 1e300});
  settings.declare(
      {"gravity.central_mass", 0.0, "G M of a mass at the origin that pulls the gas; 0: none", {}, 0, 1e300});
  settings.declare({"gravity.softening", 0.0, "of its potential - G M / sqrt(r^2 + softening^2)", {}, 0, 1e300});
}

namespace {
bool has_individual_steps(const Settings& settings) {
  const std::string& choice = settings.text("time.steps");
  return choice == "individual" || (choice == "auto" && settings.text("sph.scheme").starts_with("sphs"));
}
}  // namespace

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
          .viscosity_beta = settings.real("viscosity.beta") >= 0 ? settings.real("viscosity.beta")
                                                                 : usual_beta(settings.text("sph.scheme")),
          .alpha_entropy = settings.real("dissipation.entropy"),
          .alpha_mass = settings.real("dissipation.mass"),
          .mass_correction = std::ranges::find(mass_corrections, settings.text("dissipation.mass_form"),
                                               [](const auto& form) { return std::string(form.first); })
                                 ->second,
          .alpha_conductivity = settings.real("conductivity.alpha"),
          .conductivity = settings.text("conductivity.signal"),
          .balsara = settings.flag("viscosity.balsara"),
          .alpha_given = settings.real("switch.alpha"),
          .alpha_min = settings.real("switch.alpha_min"),
          .switch_noise = settings.real("switch.noise"),
          .balsara_limits_all = settings.text("switch.balsara") == "all",
          .motion = settings.flag("time.motion"),
          .individual_steps = has_individual_steps(settings),
          .step_limiter = settings.flag("time.limiter"),
          .h_max = settings.real("sph.h_max"),
          .max_dt = settings.real("time.max_dt"),
          .central_mass = settings.real("gravity.central_mass"),
          .softening = settings.real("gravity.softening")};
}

SchemeDescription describe(const SimulationSettings& settings, const ParticleSet& particles) {
  const Instantiation& row = choose(settings, particles.dimension, have_equal_masses(particles));
  SchemeDescription description = row.describe();
  description.scheme = settings.scheme;
  description.kernel = settings.kernel;
  description.tabulated = row.kernel.empty();
  if (row.masses == Masses::equal)
    description.left_out.push_back(fmt::format(
        "mass dissipation: {}", settings.alpha_mass == 0 ? "dissipation.mass = 0" : "all masses are equal"));
  return description;
}

std::unique_ptr<Simulation> make_simulation(const ParticleSet& particles, const SimulationSettings& settings) {
  check_runnable(particles);
  check_runnable(settings, particles);
  return choose(settings, particles.dimension, have_equal_masses(particles)).make(particles, settings);
}

}  // namespace sphk
