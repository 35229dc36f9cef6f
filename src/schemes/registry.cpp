// SPDX-License-Identifier: BSD-3-Clause
#include "src/schemes/registry.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "kernels/smoothing/list.hpp"
#include "src/engine/errors.hpp"
#include "src/engine/geometry.hpp"
#include "src/engine/loading.hpp"
#include "src/engine/output.hpp"
#include "src/engine/scaled_simulation.hpp"
#include "src/schemes/checks.hpp"
#include "src/schemes/compiled_rows.hpp"

namespace sphk {

namespace {

GasTraits traits_of(const ParticleSet& particles) {
  const auto different = std::ranges::adjacent_find(particles.m, std::ranges::not_equal_to{});
  return {.equal_masses = different == particles.m.end()};
}

/// Does the row compute what is asked, whatever its kernel?
bool answers(const Instantiation& row, const SimulationSettings& settings, int dimension) {
  return row.energy == settings.energy && row.dimension == dimension && row.precision == settings.precision;
}

/// The compiled recipe for settings that leave nothing open: in closed form where it has the kernel, else through the
/// table; of those that serve, the leanest, or the complete one where all terms are asked for.
const Instantiation& choose(const Instantiations& rows, const SimulationSettings& settings, int dimension,
                            const GasTraits& gas) {
  const Given given = given_of(settings);
  const Instantiation* best = nullptr;
  for (const bool closed_form : {true, false}) {
    for (const Instantiation& row : rows) {
      const bool fits = closed_form ? row.kernel && settings.kernel == row.kernel : !row.kernel;
      if (!fits || !answers(row, settings, dimension) || (settings.all_terms && !row.complete)) continue;
      if (row.serves(given, gas) && (!best || row.flops < best->flops)) best = &row;
    }
    if (best) return *best;
  }
  throw InputError(
      fmt::format("there is no scheme \"{}\" that integrates \"{}\" in {}D with \"{}\" precision and kernel {}",
                  settings.scheme, settings.energy, dimension, settings.precision, settings.kernel));
}

bool has_term(const Instantiation& row, const std::string& name) {
  return std::ranges::any_of(row.terms, [&](const TermFacts& term) { return term.name == name; });
}

/// What the complete recipe has and the chosen one has not, and why.
std::vector<std::string> left_out(const Instantiation& row, const Instantiation& complete, const Given& given) {
  std::vector<std::string> left;
  for (const TermFacts& term : complete.terms)
    if (!has_term(row, term.name))
      left.push_back(
          fmt::format("{}: {}", term.name, term.idle(given, {}) ? "its strength is 0" : "all masses are equal"));
  const CompiledFacts facts = row.facts(), all = complete.facts();
  for (const PassFacts& pass : all.passes) {
    const bool there = std::ranges::any_of(facts.passes, [&](const PassFacts& p) { return p.name == pass.name; });
    if (!there && pass.wanted(given)) left.push_back(fmt::format("{}: nothing that is left reads it", pass.name));
  }
  for (const FieldPlace& place : row.written)
    if (std::ranges::find(facts.fields, place.facts, &FieldPlace::facts) == facts.fields.end())
      left.push_back(fmt::format("{}: no term of this scheme reads them", place.facts->name));
  if (row.left_out) left.emplace_back(row.left_out);
  return left;
}

/// Terms that add nothing and are computed all the same: no loop without them is compiled for this kernel.
std::vector<std::string> idle_terms(const Instantiation& row, const Given& given, const GasTraits& gas) {
  std::vector<std::string> idle;
  for (const TermFacts& term : row.terms)
    if (term.idle(given, gas)) idle.emplace_back(term.name);
  return idle;
}

template <class F>
auto of_kernel(const std::string& kernel, F&& f) {
  try {
    return with_kernel(kernel, f);
  } catch (const std::invalid_argument& error) {
    throw InputError(std::string("sph.kernel: ") + error.what());
  }
}

/// The self term of a kernel that a scheme of one's own has in closed form, or of one of the list.
double least_neighbours(const Instantiations& rows, const std::string& kernel, int dimension) {
  for (const Instantiation& row : rows)
    if (row.kernel && row.kernel == kernel && row.dimension == dimension) return row.self_term;
  return min_neighbours(kernel, dimension);
}

}  // namespace

std::vector<std::string> scheme_names() {
  std::vector<std::string> names;
  for (const SchemeEntry& scheme : known_schemes())
    if (!scheme.facts->hidden) names.emplace_back(scheme.facts->name);
  return names;
}

std::vector<std::string> kernel_names() {
  return smoothing_kernel_names();
}

double min_neighbours(const std::string& kernel, int dimension) {
  return of_kernel(kernel, [&](const auto& k) { return unit_sphere_volume(dimension) * k.norm(dimension) * k.w(0.0); });
}

SchemeDescription describe(const SimulationSettings& asked, const ParticleSet& particles) {
  const SimulationSettings settings = resolved(asked, particles.dimension);
  const Instantiations& rows = compiled_rows(settings.scheme, particles.dimension);
  SimulationSettings whole = settings;
  whole.all_terms = true;
  const GasTraits gas = traits_of(particles);
  const Instantiation& row = choose(rows, settings, particles.dimension, gas);
  const Instantiation& complete = choose(rows, whole, particles.dimension, gas);
  const Given given = given_of(settings);
  const CompiledFacts facts = row.facts();
  SchemeDescription description;
  description.scheme = settings.scheme;
  description.kernel = settings.kernel;
  description.precision = settings.precision;
  description.dimension = particles.dimension;
  description.tabulated = !row.kernel;
  description.left_out = left_out(row, complete, given);
  description.idle = idle_terms(row, given, gas);
  description.bytes_per_particle = facts.bytes_per_particle + (has_own_steps(settings) ? bytes_of_own_steps : 0);
  description.flops_per_pair = facts.flops_per_pair;
  for (const PassFacts& pass : facts.passes)
    if (pass.wanted(given)) description.passes.emplace_back(pass.name);
  for (const TermFacts& term : row.terms) description.terms.emplace_back(term.name);
  for (const FieldPlace& place : facts.fields) description.fields.emplace_back(place.facts->name);
  return description;
}

Instantiations compiled_rows() {
  Instantiations all;
  for (const SchemeEntry& scheme : known_schemes())
    for (const int dimension : {1, 2, 3})
      std::ranges::copy(compiled_rows(scheme.facts->name, dimension), std::back_inserter(all));
  return all;
}

std::unique_ptr<Simulation> make_simulation(const ParticleSet& particles, const SimulationSettings& asked,
                                            const SchemeEntry& scheme, const Instantiations& rows) {
  check_runnable(particles);
  const SimulationSettings settings = resolved(asked, particles.dimension, scheme);
  check_runnable(settings, particles, least_neighbours(rows, settings.kernel, particles.dimension));
  const Instantiation& row = choose(rows, settings, particles.dimension, traits_of(particles));
  const Scale scale = settings.own_units.value_or(scale_of(particles));
  const auto make = [&] {
    return row.make(particles, in_own_units(settings, scale, scheme.numbers, particles.dimension));
  };
  return std::make_unique<ScaledSimulation>(make, scale, particles.dimension, settings.gamma);
}

std::unique_ptr<Simulation> make_simulation(const ParticleSet& particles, const SimulationSettings& settings) {
  check_runnable(particles);
  return make_simulation(particles, settings, scheme_entry(settings.scheme),
                         compiled_rows(settings.scheme, particles.dimension));
}

}  // namespace sphk
