// SPDX-License-Identifier: BSD-3-Clause
#include "src/schemes/resolve.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "kernels/passes/kick_drift.hpp"
#include "kernels/passes/state_equation.hpp"
#include "kernels/smoothing/list.hpp"
#include "src/engine/errors.hpp"
#include "src/engine/geometry.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

namespace {

/// Numbers that have a place of their own in SimulationSettings.
constexpr const Number* with_a_place[] = {&neighbour_number, &largest_support, &courant_number, &adiabatic_index};

bool has_a_place(const std::string& key) {
  return std::ranges::any_of(with_a_place, [&](const Number* number) { return key == number->key; });
}

bool is_flag(const Number& number) {
  return number.words == off_or_on;
}

std::vector<std::string> words_of(const Number& number) {
  std::vector<std::string> words;
  std::istringstream text(number.words);
  for (std::string word; std::getline(text, word, '|');) words.push_back(word);
  return words;
}

/// A number's value as users write it.
Value value_of(const Number& number, double value) {
  if (is_flag(number)) return value != 0;
  if (number.words) return words_of(number)[static_cast<std::size_t>(value)];
  return value;
}

double number_of(const Number& number, const Value& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? 1 : 0;
  if (const auto* text = std::get_if<std::string>(&value)) {
    const std::vector<std::string> words = words_of(number);
    return static_cast<double>(std::ranges::find(words, *text) - words.begin());
  }
  return std::get<double>(value);
}

void declare_number(Settings& settings, const Number& number) {
  const bool word = number.words && !is_flag(number);
  settings.declare({.name = number.key,
                    .value = value_of(number, number.standard),
                    .doc = number.meaning,
                    .choices = word ? words_of(number) : std::vector<std::string>{},
                    .min = number.min,
                    .max = number.max});
}

/// One number of each key, of all schemes.
std::vector<const Number*> numbers_of_all() {
  SchemeEntry all{};
  for (const SchemeEntry& scheme : known_schemes())
    for (const Number* number : scheme.numbers)
      if (!all.number(number->key)) all.numbers.push_back(number);
  return all.numbers;
}

[[noreturn]] void fail_without_number(const SchemeFacts& scheme, const std::string& key) {
  std::vector<std::string> having;
  for (const SchemeEntry& other : known_schemes())
    if (!other.facts->hidden && other.number(key)) having.emplace_back(other.facts->name);
  if (having.empty()) throw InputError(fmt::format("no scheme has a number \"{}\"", key));
  throw InputError(fmt::format("{} is no key of the scheme {}; {} {} it", key, scheme.name, fmt::join(having, ", "),
                               having.size() == 1 ? "has" : "have"));
}

std::string standard_energy(const SchemeEntry& scheme, bool mixes) {
  return mixes ? scheme.facts->mixing_energy : scheme.energies.front();
}

const KernelChoice& usual_of(const SchemeFacts& scheme, int dimension) {
  const KernelChoice& usual = scheme.usual[static_cast<std::size_t>(dimension - 1)];
  if (!usual.kernel) throw InputError(fmt::format("the scheme {} is not made for {}D", scheme.name, dimension));
  return usual;
}

/// What a scene prefers of the method is meant for the scheme that it prefers: under another it is forgotten.
void forget_other_method(Settings& settings, const SchemeEntry& entry, int dimension) {
  const SchemeFacts& scheme = *entry.facts;
  const auto preferred = std::ranges::find(settings.keys(), "sph.scheme", &Key::name)->preferred;
  if (!preferred || std::get<std::string>(*preferred) == scheme.name) return;
  const KernelChoice& usual = usual_of(scheme, dimension);
  settings.forget_preference("sph.kernel", std::string(usual.kernel));
  settings.forget_preference("sph.neighbours", usual.neighbours);
  settings.forget_preference("sph.energy", std::string(entry.energies.front()));
  settings.forget_preference("time.steps", std::string(scheme.steps));
  settings.forget_preference("time.courant", scheme.courant);
}

/// Kernel and neighbours of the scheme, the scene or the user, in that order of growing weight. A number that the scene
/// prefers is meant for the kernel that it prefers.
void adopt_kernel(Settings& settings, const SchemeFacts& scheme, int dimension) {
  settings.set_standard("sph.kernel", std::string(usual_of(scheme, dimension).kernel));
  const std::string kernel = settings.text("sph.kernel");
  min_neighbours(kernel, dimension);  // refuses a name that is no kernel's
  const double neighbours = usual_neighbours(scheme, kernel, dimension);
  if (settings.set_by_user("sph.kernel")) settings.forget_preference("sph.neighbours", neighbours);
  settings.set_standard("sph.neighbours", neighbours);
}

}  // namespace

const SchemeEntry& scheme_entry(const std::string& name) {
  for (const SchemeEntry& scheme : known_schemes())
    if (scheme.facts->name == name) return scheme;
  throw InputError(fmt::format("there is no scheme \"{}\"; schemes are {}", name, fmt::join(scheme_names(), ", ")));
}

double usual_neighbours(const SchemeFacts& scheme, const std::string& kernel, int dimension) {
  const KernelChoice& usual = usual_of(scheme, dimension);
  if (kernel == usual.kernel) return usual.neighbours;
  try {
    const double spacings = with_kernel(kernel, [](const auto& k) { return k.spacings; });
    return std::max(usual.neighbours, std::round(unit_sphere_volume(dimension) * std::pow(spacings, dimension)));
  } catch (const std::invalid_argument&) {  // a kernel of one's own
    return usual.neighbours;
  }
}

SimulationSettings resolved(SimulationSettings settings, int dimension, const SchemeEntry& entry) {
  const SchemeFacts& scheme = *entry.facts;
  for (const auto& [key, value] : settings.numbers.values())
    if (!entry.number(key)) fail_without_number(scheme, key);
  if (settings.kernel.empty()) settings.kernel = usual_of(scheme, dimension).kernel;
  if (settings.neighbours == 0) settings.neighbours = usual_neighbours(scheme, settings.kernel, dimension);
  if (settings.energy.empty()) settings.energy = entry.energies.front();
  if (settings.courant == 0) settings.courant = scheme.courant;
  if (settings.steps.empty()) settings.steps = scheme.steps;
  return settings;
}

SimulationSettings resolved(const SimulationSettings& settings, int dimension) {
  return resolved(settings, dimension, scheme_entry(settings.scheme));
}

SimulationSettings under_scheme(SimulationSettings settings, const std::string& scheme) {
  const SchemeEntry& entry = scheme_entry(scheme);
  Given numbers;
  for (const auto& [key, value] : settings.numbers.values())
    if (entry.number(key)) numbers.set(key, value);
  settings.numbers = numbers;
  settings.scheme = scheme;
  settings.energy.clear();
  return settings;
}

void declare_engine_keys(Settings& settings) {
  const SimulationSettings standard;
  settings.declare({"sph.scheme", standard.scheme, "method of the momentum equation", scheme_names()});
  settings.declare({"sph.kernel", "cs", "smoothing kernel; liq takes its core edge, as in liq0.4", {}});
  declare_number(settings, neighbour_number);
  settings.declare({"sph.precision",
                    standard.precision,
                    "pair arithmetic: float with double state and sums, or double",
                    {"mixed", "double"}});
  settings.declare(
      {"sph.energy", EntropyForm::name, "integrated thermal variable", {EntropyForm::name, EnergyForm::name}});
  declare_number(settings, adiabatic_index);
  declare_number(settings, largest_support);
  for (const Number* number : numbers_of_all())
    if (!has_a_place(number->key)) declare_number(settings, *number);
  settings.declare({"time.steps",
                    global_steps,
                    "steps of the particles' own in powers of two, or one for all",
                    {own_steps, global_steps}});
  settings.declare({"time.limiter",
                    standard.step_limiter,
                    "keep the steps of neighbours within a factor 4 (Saitoh & Makino 2009), and let neighbours that "
                    "ask for unlike steps begin with one",
                    {}});
  declare_number(settings, courant_number);
  settings.declare({"time.max_dt", standard.max_dt, "largest time-step; 0: no limit", {}, 0, 1e300});
}

void adopt_scheme(Settings& settings, int dimension, bool mixes) {
  const SchemeEntry& entry = scheme_entry(settings.text("sph.scheme"));
  const SchemeFacts& scheme = *entry.facts;
  for (const Number* number : numbers_of_all()) {
    if (has_a_place(number->key) || !settings.has(number->key)) continue;
    if (const Number* mine = entry.number(number->key))
      settings.set_standard(number->key, value_of(*mine, mine->standard));
    else if (settings.set_by_user(number->key))
      fail_without_number(scheme, number->key);
    else
      settings.remove(number->key);
  }
  forget_other_method(settings, entry, dimension);
  adopt_kernel(settings, scheme, dimension);
  settings.set_standard("sph.energy", standard_energy(entry, mixes));
  settings.set_standard("time.steps", std::string(scheme.steps));
  settings.set_standard("time.courant", scheme.courant);
}

SimulationSettings simulation_settings(const Settings& settings) {
  SimulationSettings simulation{.scheme = settings.text("sph.scheme"),
                                .kernel = settings.text("sph.kernel"),
                                .precision = settings.text("sph.precision"),
                                .energy = settings.text("sph.energy"),
                                .neighbours = settings.real("sph.neighbours"),
                                .gamma = settings.real("sph.gamma"),
                                .courant = settings.real("time.courant"),
                                .steps = settings.text("time.steps"),
                                .step_limiter = settings.flag("time.limiter"),
                                .h_max = settings.real("sph.h_max"),
                                .max_dt = settings.real("time.max_dt"),
                                .numbers = {}};
  for (const Number* number : scheme_entry(simulation.scheme).numbers) {
    const auto key = std::ranges::find(settings.keys(), number->key, &Key::name);
    if (!has_a_place(number->key) && key != settings.keys().end())
      simulation.numbers.set(number->key, number_of(*number, key->value));
  }
  return simulation;
}

}  // namespace sphk
