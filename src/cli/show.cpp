// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"
#include "src/report/quantity.hpp"
#include "src/run/trial_gas.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

namespace {

constexpr const char* next_line = "\n               ";

void print_list(const char* title, const std::vector<std::string>& items, const char* separator) {
  if (!items.empty()) fmt::print("  {:<12} {}\n", title, fmt::join(items, separator));
}

/// A comma-separated list in lines of about 100 characters.
std::vector<std::string> wrapped(const std::vector<std::string>& words) {
  std::vector<std::string> lines{""};
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (lines.back().size() + words[k].size() > 100) lines.emplace_back();
    lines.back() += words[k] + (k + 1 < words.size() ? ", " : "");
  }
  return lines;
}

/// How scene and scheme depart from their papers, the scheme in so many dimensions.
std::vector<std::string> differences(const Problem& problem, const SchemeFacts& facts, int dimension) {
  std::vector<std::string> differ;
  for (const PaperChoice& choice : departures(problem))
    differ.push_back(
        fmt::format("{}{}{}", choice.paper, choice.keys.empty() ? "" : ": --set ", fmt::join(choice.keys, " --set ")));
  if (facts.differs) differ.push_back(fmt::format("from the paper: {}", facts.differs));
  const char *usual = facts.usual[dimension - 1].kernel, *in_space = facts.usual[2].kernel;
  if (std::string_view(usual) != in_space)
    differ.push_back(fmt::format("from the paper: {} is usual in {}D in place of {}", usual, dimension, in_space));
  return differ;
}

void print_keys(const Settings& settings) {
  const char* origin[] = {"default", "scene", "file", "command line"};
  fmt::print("\n  {:<20} {:<20} {:<13} {}\n", "key", "value", "set by", "meaning");
  for (const Key& key : settings.keys()) {
    const std::string value = to_text(key.value);
    fmt::print("  {:<20} {:<20} {:<13} {}", key.name, value, origin[static_cast<int>(key.origin)], key.doc);
    if (!key.choices.empty() && key.choices.size() <= 6) fmt::print(" [{}]", fmt::join(key.choices, ", "));
    fmt::print("\n");
  }
}

int show_command(const std::string& what, const std::vector<Override>& overrides) {
  const Problem problem = resolve_problem(what, overrides);
  const TrialGas trial = trial_gas(*problem.scene, with_lattice(problem.settings));
  const SchemeDescription d = describe(simulation_settings(problem.settings), trial.gas);
  const Array3& size = trial.gas.box.size;
  fmt::print("{}: {}\n\n", problem.scene->name(), problem.scene->summary());
  fmt::print("  {:<12} {}{:.0f} in {}D, box {:g} x {:g} x {:g}\n", "particles", trial.refinement > 1 ? "about " : "",
             trial.particles, d.dimension, size[0], size[1], size[2]);
  fmt::print("  {:<12} {}, kernel {}{}, {:g} neighbours, {} precision\n", "scheme", d.scheme, d.kernel,
             d.tabulated ? " (tabulated)" : "", problem.settings.real("sph.neighbours"), d.precision);
  const SchemeFacts& facts = *scheme_entry(d.scheme).facts;
  print_list("", {facts.summary}, "");
  print_list("differs", differences(problem, facts, d.dimension), next_line);
  print_list("passes", d.passes, " -> ");
  print_list("terms", d.terms, next_line);
  print_list("fields", wrapped(d.fields), next_line);
  fmt::print("  {:<12} {:.0f} bytes per particle ({}), {:.0f} operations per pair\n", "cost", d.bytes_per_particle,
             bytes_text(d.bytes_per_particle * trial.particles), d.flops_per_pair);
  print_list("left out", d.left_out, next_line);
  print_list("idle", d.idle, next_line);
  print_keys(problem.settings);
  return ExitCode::done;
}

}  // namespace

void add_show(CLI::App& root, Options& o) {
  CLI::App& show = *root.add_subcommand("show", "what a scene computes, and every key with its meaning");
  show.add_option("what", o.what, "a scene, a scene file or an initial condition")->required();
  add_physics(show, o);
  shortcut(show, o, "-n,--resolution", "scene.n", "N", "the scene's resolution (key scene.n)");
  show.footer("Example:\n  sphk show sod --kernel hoct4 --neighbours 442");
  computes(show, o, [&o] { return show_command(o.what, overrides(o)); });
}

}  // namespace sphk
