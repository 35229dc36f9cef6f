#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "src/cli/child.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/stop_signal.hpp"
#include "src/cli/study_record.hpp"
#include "src/cli/trials.hpp"
#include "src/engine/errors.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/io/reader.hpp"
#include "src/report/history.hpp"
#include "src/report/quantity.hpp"
#include "src/report/table.hpp"
#include "src/report/text_file.hpp"
#include "src/study/extremes.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* longest = "600";  // wall-clock seconds that a case may take

/// Columns of the last snapshot that no run may spoil.
Outcome check_numbers(const fs::path& snapshot) {
  const hdf5::File file = hdf5::File::open(snapshot);
  const hdf5::Group gas = file.group("PartType0");
  for (const char* name :
       {"Coordinates", "Velocities", "Masses", "Densities", "InternalEnergies", "Pressures", "Entropies"}) {
    const auto values = gas.dataset(name).read<double>();
    const bool positive = std::string(name) != "Coordinates" && std::string(name) != "Velocities";
    const auto wrong =
        std::ranges::find_if(values, [&](double value) { return !std::isfinite(value) || (positive && !(value > 0)); });
    if (wrong != values.end())
      return {"finite, > 0", fmt::format("{} {:g} at row {}", name, *wrong, wrong - values.begin()), false};
  }
  return {"finite, > 0", "yes", true};
}

/// Distance of the foremost shock from where the exact solution has it, in support radii of the gas ahead: a shock is
/// as wide. It is where the density, from the right, first passes the mean of both sides.
double front_distance(const fs::path& folder) {
  const Problem problem = resolve_problem((folder / "scene.used.toml").string(), {});
  const ParticleSet gas = read_particles(folder / "snap_0001.hdf5").particles;
  const std::vector<double> rho =
      hdf5::File::open(folder / "snap_0001.hdf5").group("PartType0").dataset("Densities").read<double>();
  const PlotHint hint = problem.scene->plot_hint(problem.settings);
  const auto exact = problem.scene->exact(problem.settings);
  const double ahead = exact({hint.to, 0, 0}, gas.time).rho;
  double place = hint.to;
  const double step = 1e-5 * (hint.to - hint.from);
  while (place > hint.from && std::abs(exact({place, 0, 0}, gas.time).rho / ahead - 1) < 0.01) place -= step;
  const double middle = std::sqrt(ahead * exact({place - 10 * step, 0, 0}, gas.time).rho);
  double found = hint.from, first_ahead = hint.to, h = 1;
  for (std::size_t i = 0; i < gas.size(); ++i)
    if (gas.x[i][0] < hint.to && gas.x[i][0] > found && rho[i] > middle) found = gas.x[i][0];
  for (std::size_t i = 0; i < gas.size(); ++i)
    if (gas.x[i][0] > std::max(found, place) && gas.x[i][0] < first_ahead && rho[i] < 1.1 * ahead)
      first_ahead = gas.x[i][0], h = gas.h[i];
  return std::abs(found - place) / h;
}

double quantity_of(const std::string& name, const fs::path& folder, const Json& run) {
  if (name == "front") return front_distance(folder);
  if (name == "energy" || name == "momentum") return run["conservation"][name];
  if (name.starts_with("l1_")) return run["errors"][name.substr(3)]["l1"];
  return read_history(folder / "history.csv").back().at(name);
}

std::vector<Outcome> outcomes_of(const ExtremeCase& one, const fs::path& folder) {
  std::vector<Outcome> outcomes{check_numbers(folder / "snap_0001.hdf5")};
  const Json run = read_json(folder / "run.json");
  for (const Requirement& requirement : one.requirements) {
    const double value = quantity_of(requirement.quantity, folder, run);
    outcomes.push_back({fmt::format("{} < {:g}", requirement.quantity, requirement.bound), fmt::format("{:.2g}", value),
                        value < requirement.bound});
  }
  return outcomes;
}

/// What a case comes to; an error ends it alone.
std::vector<Outcome> outcomes_of(const Trial& one, const Workshop& shop) {
  try {
    return one.perform(shop);
  } catch (const std::exception& error) {
    return {{"no error", error.what(), false}};
  }
}

}  // namespace

std::vector<Outcome> perform(const ExtremeCase& one, const fs::path& folder, int threads) {
  std::vector<std::string> words{"run",        one.scene, "--out", folder.string(),     "--overwrite",
                                 "--walltime", longest,   "--set", "output.snapshots=1"};
  for (const auto& [key, value] : one.keys) words.insert(words.end(), {"--set", key + "=" + value});
  if (threads > 0) words.insert(words.end(), {"--threads", std::to_string(threads)});
  const fs::path log = folder.string() + ".log";
  const int code = run_child(words, log);
  if (code == ExitCode::stopped) return {{"finishes", fmt::format("not in {} s", longest), false}};
  if (code != ExitCode::done) return {{"finishes", reason_of(code, log), false}};
  return outcomes_of(one, folder);
}

int extremes_command(const ExtremesOptions& options) {
  std::vector<Trial> wanted;
  for (const ExtremeCase& one : extreme_cases())
    wanted.push_back({one.name, one.setup, [&one](const Workshop& w) { return perform(one, w.folder, w.threads); }});
  wanted.insert(wanted.end(), further_trials().begin(), further_trials().end());
  for (const std::string& name : options.cases)
    if (std::ranges::find(wanted, name, &Trial::name) == wanted.end()) {
      std::vector<std::string> names;
      for (const Trial& one : wanted) names.push_back(one.name);
      throw InputError(fmt::format("there is no case \"{}\"; known are {}", name, fmt::join(names, ", ")));
    }
  std::erase_if(wanted, [&](const Trial& one) {
    return !options.cases.empty() && std::ranges::find(options.cases, one.name) == options.cases.end();
  });
  const fs::path folder = options.out.value_or("extremes");
  fs::create_directories(folder);
  catch_stop_signals();
  Table table{{"case", "setup", "required", "found", ""}, {}, {0, 1, 2, 3, 4}};
  int failures = 0;
  for (const Trial& one : wanted) {
    fmt::print("{} ...", one.name);
    std::fflush(stdout);
    fs::create_directories(folder / one.name);
    const std::vector<Outcome> outcomes = outcomes_of(one, {folder / one.name, options.threads});
    if (stop_requested()) return ExitCode::stopped;
    const bool passed = std::ranges::all_of(outcomes, &Outcome::passed);
    failures += !passed;
    fmt::print(" {}\n", passed ? "pass" : "FAIL");
    for (const Outcome& outcome : outcomes) {
      const bool first = &outcome == &outcomes.front();
      table.rows.push_back({first ? one.name : "", first ? one.setup : "", outcome.required, outcome.found,
                            outcome.passed ? "pass" : "FAIL"});
    }
  }
  const std::string text = table.text();
  fmt::print("\n{}\n{} of {} cases pass\n", text, wanted.size() - static_cast<std::size_t>(failures), wanted.size());
  write_text(folder / "extremes.txt", text);
  return failures == 0 ? ExitCode::done : ExitCode::numerics;
}

}  // namespace sphk
