// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/rates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>

#include "kernels/terms/switched_pair.hpp"
#include "kernels/terms/viscosity_gingold_monaghan.hpp"
#include "src/engine/errors.hpp"
#include "src/run/run_output.hpp"
#include "src/scenes/initial_condition.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

namespace {

/// Rows of the input by rising id, as the simulation has its fields.
std::vector<std::size_t> rows_by_id(const std::vector<std::uint64_t>& ids) {
  std::vector<std::size_t> rows(ids.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  std::ranges::sort(rows, {}, [&](std::size_t row) { return ids[row]; });
  return rows;
}

Field in_input_order(const Field& field, const std::vector<std::size_t>& rows) {
  Field sorted = field;
  const auto width = static_cast<std::size_t>(field.components);
  for (std::size_t place = 0; place < rows.size(); ++place)
    std::copy_n(&field.values[place * width], width, &sorted.values[rows[place] * width]);
  return sorted;
}

/// What --alpha asks for, as keys of the run; `particles` keep the file's Alpha only where that is asked.
std::vector<Override> dissipation(const std::string& alpha, const Settings& settings, ParticleSet& particles) {
  if (alpha != "file") particles.alpha.clear();
  const bool switched = settings.has(switch_alpha.key);
  if (alpha == "file") {
    if (!switched)
      throw InputError(fmt::format("--alpha file: the scheme {} has no switch; give a number, or use one that has",
                                   settings.text("sph.scheme")));
    if (particles.alpha.empty())
      throw InputError("--alpha file: the file has no field Alpha; use --alpha auto, or give a number");
    return {};
  }
  if (alpha == "auto") {
    if (switched) return {};
    std::vector<Override> none{{viscosity_alpha.key, "0", "--alpha auto"}};
    if (settings.has(viscosity_beta.key)) none.push_back({viscosity_beta.key, "0", "--alpha auto"});
    return none;
  }
  return {{switched ? switch_alpha.key : viscosity_alpha.key, alpha, "--alpha " + alpha}};
}

}  // namespace

RatesResult rates(const RatesRequest& request) {
  std::vector<Override> overrides = request.overrides;
  for (const Override& usual : {Override{"sph.precision", "double", ""}, Override{"time.steps", "global", ""}})
    if (std::ranges::find(overrides, usual.name, &Override::name) == overrides.end()) overrides.push_back(usual);
  if (std::error_code none; std::filesystem::equivalent(request.file, request.out, none))
    throw InputError(fmt::format("--out {} would replace the file that the rates are of; choose another name",
                                 request.out.string()));
  Problem problem = resolve_problem(request.file, overrides);
  ParticleSet particles = initial_condition(*problem.scene, problem.settings);
  for (const Override& key : dissipation(request.alpha, problem.settings, particles))
    problem.settings.set_from_text(key.name, key.text, Origin::command_line);
  if (particles.id.empty()) {
    particles.id.resize(particles.size());
    std::iota(particles.id.begin(), particles.id.end(), std::uint64_t{1});
  }
  SimulationSettings settings = simulation_settings(problem.settings);
  settings.all_terms = true;
  const auto simulation = make_simulation(particles, settings);
  const auto rows = rows_by_id(particles.id);
  std::vector<Field> fields;
  for (const Field& field : simulation->rates(request.split)) fields.push_back(in_input_order(field, rows));
  const double gamma = problem.settings.real("sph.gamma");
  write_fields(request.out, particles, fields, gamma, snapshot_info(*problem.scene, problem.settings));
  RatesResult result{fields.size(), particles.size(), simulation->warnings()};
  std::ranges::copy(input_remarks(problem), std::inserter(result.warnings, result.warnings.begin()));
  for (const std::string& remark : limits_met(problem, particles)) result.warnings.push_back(remark);
  return result;
}

}  // namespace sphk
