#include <fmt/format.h>

#include <algorithm>

#include "src/cli/commands.hpp"
#include "src/cli/extreme_outcomes.hpp"
#include "src/cli/trials.hpp"
#include "src/engine/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/report/table.hpp"
#include "src/run/stop_signal.hpp"
#include "src/study/child.hpp"
#include "src/study/extremes.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

constexpr const char* longest = "600";  // wall-clock seconds that a case may take

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
  std::vector<std::string> words{one.scene,    "--out", folder.string(), "--overwrite",
                                 "--walltime", longest, "--set",         "output.snapshots=1"};
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
  write_atomically(folder / "extremes.txt", text);
  return failures == 0 ? ExitCode::done : ExitCode::numerics;
}

}  // namespace sphk
