// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/child.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "src/engine/errors.hpp"
#include "src/report/process.hpp"
#include "src/run/stop_signal.hpp"

namespace sphk {

namespace fs = std::filesystem;

std::vector<std::string> run_arguments(const std::string& what, const KeyTexts& keys, const fs::path& folder,
                                       int threads) {
  std::vector<std::string> words{what, "--out", folder.string(), "--overwrite"};
  for (const auto& [key, text] : last_of_each(keys)) words.insert(words.end(), {"--set", key + "=" + text});
  if (threads > 0) words.insert(words.end(), {"--threads", std::to_string(threads)});
  return words;
}

int run_child(const std::vector<std::string>& arguments, const fs::path& log, const std::function<void()>& watch) {
  std::vector<std::string> words{this_executable().string(), "run"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  words.emplace_back("--json-log");
  Process child(words, {.output = log});
  bool asked = false;
  for (int tick = 0; !child.exit_code(); ++tick) {
    if (stop_requested() && !asked) {
      child.ask_to_stop();
      asked = true;
    }
    if (watch && tick % 10 == 0) watch();
    std::this_thread::sleep_for(std::chrono::milliseconds(tick < 20 ? 5 : 50));
  }
  if (child.wait() == Process::not_started)
    throw InputError(
        fmt::format("cannot start {} with its output in {}: may you write there?", words[0], log.string()));
  return child.wait();
}

nlohmann::json last_with(const std::string& key, const fs::path& log) {
  std::ifstream file(log);
  nlohmann::json last;
  for (std::string line; std::getline(file, line);) {
    auto json = nlohmann::json::parse(line, nullptr, false);
    if (json.is_object() && json.contains(key)) last = std::move(json);
  }
  return last;
}

std::string reason_of(int code, const fs::path& log) {
  if (code == Process::by_signal + SIGKILL) return "killed from outside: was there enough memory?";
  if (code > Process::by_signal) return fmt::format("ended by signal {}", code - Process::by_signal);
  const nlohmann::json last = last_with("error", log);
  return last.is_null() ? fmt::format("exit code {}", code) : last["error"].get<std::string>();
}

double share_done(const fs::path& log) {
  const nlohmann::json last = last_with("end", log);
  if (last.is_null() || !(last["end"] > 0)) return 0;
  return std::clamp(last["time"].get<double>() / last["end"].get<double>(), 0.0, 1.0);
}

}  // namespace sphk
