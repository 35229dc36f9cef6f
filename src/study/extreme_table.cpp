// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/extreme_table.hpp"
#include "src/report/print.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "src/engine/errors.hpp"
#include "src/engine/places.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/reader.hpp"
#include "src/report/process.hpp"
#include "src/report/table.hpp"
#include "src/run/failure.hpp"
#include "src/run/problem.hpp"
#include "src/run/stop_signal.hpp"
#include "src/study/extreme_run.hpp"
#include "src/study/extremes.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

constexpr const char* longest = "600";  // wall-clock seconds that a case may take

/// What a requirement came to.
struct Outcome {
  std::string required, found;
  bool passed = false;
};

/// `sphk run` with these keys, and one snapshot beside the first; throws what it ends with where that is an error.
void run_sphk(const std::string& what, KeyTexts keys, const fs::path& folder, int threads) {
  keys.emplace_back("output.snapshots", "1");
  std::vector<std::string> words = run_arguments(what, keys, folder, threads);
  words.insert(words.end(), {"--walltime", longest});
  const fs::path log = folder.string() + ".log";
  const int code = run_child(words, log);
  if (code == ExitCode::stopped) throw NumericsError(fmt::format("not in {} s", longest));
  if (code != ExitCode::done) throw NumericsError(reason_of(code, log));
}

/// How far one thread and two get apart in three steps after the run. A snapshot keeps its method.
Quantity threads_apart(const fs::path& folder) {
  const fs::path start = folder / "snap_0001.hdf5", one = folder / "threads_1", two = folder / "threads_2";
  const double end = 2 * read_particles(start).particles.time;
  const KeyTexts keys{{"time.max_steps", "3"}, {"time.end", fmt::format("{}", end)}};
  run_sphk(start.string(), keys, one, 1);
  run_sphk(start.string(), keys, two, 2);
  return {difference(one / "snap_0001.hdf5", two / "snap_0001.hdf5"), ""};
}

Outcome outcome_of(const Requirement& requirement, const FinishedRun& run) {
  try {
    const std::string& name = requirement.quantity;
    const Quantity found = name == "threads" ? threads_apart(run.folder) : quantity_of(name, run);
    return {requirement.text(), fmt::format("{:.2g}{}{}", found.value, found.where.empty() ? "" : ": ", found.where),
            requirement.met_by(found.value)};
  } catch (const std::exception& error) {
    return {requirement.text(), error.what(), false};
  }
}

std::vector<Outcome> perform(const ExtremeCase& one, const fs::path& folder, int threads) {
  try {
    run_sphk(one.scene, one.keys, folder, threads);
  } catch (const std::exception& error) {
    return {{"finishes", error.what(), false}};
  }
  const Problem problem = resolve_problem((folder / "scene.used.toml").string(), {});
  std::vector<Outcome> outcomes;
  for (const Requirement& requirement : one.requirements)
    outcomes.push_back(outcome_of(requirement, {folder, *problem.scene, problem.settings}));
  return outcomes;
}

/// The cases of the files that are named, or of those that come with sphk; of these the ones that are named, or all.
std::vector<ExtremeCase> wanted_cases(Batch batch) {
  const auto check = [](const std::string& scene, const KeyTexts& keys) { resolve_problem(scene, overrides_of(keys)); };
  const auto is_file = [](const std::string& name) { return name.ends_with(".toml"); };
  std::vector<ExtremeCase> cases;
  for (const std::string& name : batch.names)
    if (is_file(name)) std::ranges::move(read_extremes(name, check), std::back_inserter(cases));
  if (std::erase_if(batch.names, is_file) == 0) cases = extremes_in(shared_folder() / "studies" / "extremes", check);
  std::vector<std::string> there;
  std::ranges::transform(cases, std::back_inserter(there), &ExtremeCase::name);
  for (const std::string& name : batch.names)
    if (std::ranges::find(there, name) == there.end())
      throw InputError(fmt::format("there is no case \"{}\"; known are {}", name, fmt::join(there, ", ")));
  std::erase_if(cases, [&](const ExtremeCase& one) { return !batch.wants(one.name); });
  return cases;
}

}  // namespace

bool make_extremes(const Batch& batch) {
  const std::vector<ExtremeCase> cases = wanted_cases(batch);
  const fs::path folder = batch.out.value_or("extremes");
  fs::create_directories(folder);
  catch_stop_signals();
  Table table{{"case", "setup", "required", "found", ""}, {}, {0, 1, 2, 3, 4}};
  std::size_t passes = 0;
  for (const ExtremeCase& one : cases) {
    say("{} ...", one.name);
    const std::vector<Outcome> outcomes = perform(one, folder / one.name, batch.threads);
    if (stop_requested()) return false;
    const bool passed = std::ranges::all_of(outcomes, &Outcome::passed);
    passes += passed;
    say(" {}\n", passed ? "pass" : "FAIL");
    for (const Outcome& outcome : outcomes) {
      const bool first = &outcome == &outcomes.front();
      table.rows.push_back({first ? one.name : "", first ? one.summary : "", outcome.required, outcome.found,
                            outcome.passed ? "pass" : "FAIL"});
    }
  }
  const std::string text = table.text();
  say("\n{}\n{} of {} cases pass\n", text, passes, cases.size());
  write_atomically(folder / "extremes.txt", text);
  return passes == cases.size();
}

}  // namespace sphk
