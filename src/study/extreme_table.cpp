#include "src/study/extreme_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "src/engine/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/reader.hpp"
#include "src/report/process.hpp"
#include "src/report/table.hpp"
#include "src/run/failure.hpp"
#include "src/run/problem.hpp"
#include "src/run/stop_signal.hpp"
#include "src/study/child.hpp"
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

/// `sphk run` with these words; throws what it ends with where that is an error.
void run_sphk(std::vector<std::string> words, const fs::path& folder, int threads) {
  words.insert(words.end(), {"--out", folder.string(), "--overwrite", "--set", "output.snapshots=1"});
  if (threads > 0) words.insert(words.end(), {"--threads", std::to_string(threads)});
  const fs::path log = folder.string() + ".log";
  const int code = run_child(words, log);
  if (code == ExitCode::stopped) throw NumericsError(fmt::format("not in {} s", longest));
  if (code != ExitCode::done) throw NumericsError(reason_of(code, log));
}

/// How far one thread and two get apart in three steps after the run. A snapshot keeps its method.
Quantity threads_apart(const fs::path& folder) {
  const fs::path start = folder / "snap_0001.hdf5", one = folder / "threads_1", two = folder / "threads_2";
  const double end = 2 * read_particles(start).particles.time;
  const std::vector<std::string> words{start.string(), "--steps", "3", "--t-end", fmt::format("{}", end)};
  run_sphk(words, one, 1);
  run_sphk(words, two, 2);
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
  std::vector<std::string> words{one.scene, "--walltime", longest};
  for (const auto& [key, value] : one.keys) words.insert(words.end(), {"--set", key + "=" + value});
  try {
    run_sphk(words, folder, threads);
  } catch (const std::exception& error) {
    return {{"finishes", error.what(), false}};
  }
  const Problem problem = resolve_problem((folder / "scene.used.toml").string(), {});
  std::vector<Outcome> outcomes;
  for (const Requirement& requirement : one.requirements)
    outcomes.push_back(outcome_of(requirement, {folder, *problem.scene, problem.settings}));
  return outcomes;
}

/// Throws InputError where a run would not begin with these keys.
void check_keys(const std::string& scene, const ExtremeCase::Keys& keys) {
  std::vector<Override> overrides;
  for (const auto& [key, value] : keys) overrides.push_back({key, value, key + "=" + value});
  resolve_problem(scene, overrides);
}

/// The cases of the files that are named, or of those that come with sphk; of these the ones that are named, or all.
std::vector<ExtremeCase> wanted_cases(const std::vector<std::string>& words) {
  std::vector<std::string> names;
  std::vector<ExtremeCase> cases;
  for (const std::string& word : words)
    if (word.ends_with(".toml"))
      std::ranges::move(read_extremes(word, check_keys), std::back_inserter(cases));
    else
      names.push_back(word);
  if (names.size() == words.size()) cases = extremes_in(shared_folder() / "studies" / "extremes", check_keys);
  std::vector<std::string> there;
  for (const ExtremeCase& one : cases) there.push_back(one.name);
  for (const std::string& name : names)
    if (std::ranges::find(there, name) == there.end())
      throw InputError(fmt::format("there is no case \"{}\"; known are {}", name, fmt::join(there, ", ")));
  std::erase_if(cases, [&](const ExtremeCase& one) {
    return !names.empty() && std::ranges::find(names, one.name) == names.end();
  });
  return cases;
}

}  // namespace

bool make_extremes(const ExtremesRequest& request) {
  const std::vector<ExtremeCase> cases = wanted_cases(request.cases);
  const fs::path folder = request.out.value_or("extremes");
  fs::create_directories(folder);
  catch_stop_signals();
  Table table{{"case", "setup", "required", "found", ""}, {}, {0, 1, 2, 3, 4}};
  std::size_t passes = 0;
  for (const ExtremeCase& one : cases) {
    fmt::print("{} ...", one.name);
    std::fflush(stdout);
    const std::vector<Outcome> outcomes = perform(one, folder / one.name, request.threads);
    if (stop_requested()) return false;
    const bool passed = std::ranges::all_of(outcomes, &Outcome::passed);
    passes += passed;
    fmt::print(" {}\n", passed ? "pass" : "FAIL");
    for (const Outcome& outcome : outcomes) {
      const bool first = &outcome == &outcomes.front();
      table.rows.push_back({first ? one.name : "", first ? one.summary : "", outcome.required, outcome.found,
                            outcome.passed ? "pass" : "FAIL"});
    }
  }
  const std::string text = table.text();
  fmt::print("\n{}\n{} of {} cases pass\n", text, passes, cases.size());
  write_atomically(folder / "extremes.txt", text);
  return passes == cases.size();
}

}  // namespace sphk
