#include "src/cli/trials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "src/cli/guards.hpp"
#include "src/report/process.hpp"
#include "src/study/odd_cases.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The first of the words that is missing from, or should not be in, what a command printed; empty: all is well.
std::string missing(const Command& command, const std::string& text) {
  for (const std::string& part : command.says)
    if (text.find(part) == std::string::npos) return fmt::format("does not say \"{}\"", part);
  for (const std::string& part : command.not_says)
    if (text.find(part) != std::string::npos) return fmt::format("says \"{}\"", part);
  return "";
}

}  // namespace

std::vector<Outcome> perform_all(const std::vector<ExtremeCase>& cases, const Workshop& shop) {
  std::vector<Outcome> all;
  for (const ExtremeCase& one : cases)
    for (const Outcome& outcome : perform(one, shop.folder / one.name, shop.threads)) {
      const auto same = std::ranges::find(all, outcome.required, &Outcome::required);
      if (same == all.end()) {
        all.push_back(outcome);
        continue;
      }
      if (outcome.found != same->found) same->found += ", " + outcome.found;
      same->passed = same->passed && outcome.passed;
    }
  return all;
}

int run_alone(std::vector<std::string> words, const fs::path& log) {
  words.insert(words.begin(), this_executable().string());
  return Process(words, {.output = log}).wait();
}

Outcome try_commands(const std::string& required, const std::vector<Command>& commands, const Workshop& shop) {
  std::size_t good = 0;
  std::string first;
  for (const Command& command : commands) {
    std::vector<std::string> words = command.words;
    if (shop.threads > 0) words.insert(words.end(), {"--threads", std::to_string(shop.threads)});
    static int number = 0;
    const fs::path log = shop.folder / fmt::format("command-{:02}.log", ++number);
    const int code = run_alone(words, log);
    const std::string problem =
        code != command.code ? fmt::format("exit code {}", code) : missing(command, text_of(log));
    good += problem.empty();
    if (!problem.empty() && first.empty())
      first = fmt::format("; {} (sphk {}): {}", log.string(), fmt::join(words, " "), problem);
  }
  return {required, fmt::format("{} of {}{}", good, commands.size(), first), first.empty()};
}

const std::vector<Trial>& further_trials() {
  static const std::vector<Trial> all = [] {
    std::vector<Trial> list = guards_of_gas();
    for (const Trial& one : guards_of_files()) list.push_back(one);
    for (const OddArrangement& odd : odd_arrangements())
      list.push_back({odd.name, odd.setup, [&odd](const Workshop& shop) { return perform_all(odd.cases, shop); }});
    list.push_back({"slabs", "thin boxes, 442 neighbours", compare_slabs});
    return list;
  }();
  return all;
}

}  // namespace sphk
