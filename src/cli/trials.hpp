#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "src/study/extremes.hpp"

namespace sphk {

/// What a requirement came to.
struct Outcome {
  std::string required, found;
  bool passed = false;
};

/// Where a case leaves its files, and the threads of its runs (0: what OpenMP gives).
struct Workshop {
  std::filesystem::path folder;
  int threads = 0;
  std::string path(const std::string& name) const { return (folder / name).string(); }
};

/// A case of `sphk extremes`.
struct Trial {
  std::string name, setup;
  std::function<std::vector<Outcome>(const Workshop&)> perform;
};

/// Cases that are more than a run of a scene: wrong input, which has to end with a sentence and its exit code; what
/// looks wrong and is not; odd arrangements; thin slabs.
const std::vector<Trial>& further_trials();

/// Runs a case into `folder`: whether it finished with sound numbers, and its requirements.
std::vector<Outcome> perform(const ExtremeCase& one, const std::filesystem::path& folder, int threads);
/// Runs several, each in a folder of its own, and joins what they find, requirement by requirement.
std::vector<Outcome> perform_all(const std::vector<ExtremeCase>& cases, const Workshop& shop);

/// A command line, and what has to come of it.
struct Command {
  std::vector<std::string> words;     ///< after "sphk"
  int code = 0;                       ///< exit code
  std::vector<std::string> says;      ///< parts of what it prints
  std::vector<std::string> not_says;  ///< nothing of these
};

/// The exit code of `sphk WORDS`, its output in `log`.
int run_alone(std::vector<std::string> words, const std::filesystem::path& log);

/// One row on all of them: how many came to what they have to, or what else the first of the others came to. Their logs
/// stay in the folder.
Outcome try_commands(const std::string& required, const std::vector<Command>& commands, const Workshop& shop);

}  // namespace sphk
