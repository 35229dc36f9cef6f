#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "src/cli/command_line.hpp"
#include "src/cli/commands.hpp"

namespace CLI {
class App;
}

namespace sphk {

/// Everything the options write to, and what the command then does; lives as long as the request.
struct Options {
  Request request;
  std::string what, file;
  std::vector<std::string> sets;
  std::vector<Override> shortcuts;
  std::string out, report, resume;
  int threads = 0;
  RunOptions run;
  PlotRequest plot;
  StabilityOptions stability;
  StudyRequest study;
  std::vector<std::string> studies;  ///< what `sphk study` is given: one, or the word compare and two
  std::vector<std::string> scenes;
  bool split = false;
  std::string alpha = "auto";
};

/// Nothing where the text is empty.
std::optional<std::filesystem::path> path_of(const std::string& text);

/// The shortcuts and the --set options, in that order. Throws InputError.
std::vector<Override> overrides(const Options& o);

/// What a command does once its options are read: on Kokkos, or without it.
void computes(CLI::App& app, Options& o, const std::function<int()>& act);
void acts(CLI::App& app, Options& o, const std::function<int()>& act);

/// An option that is short for `--set key=...`.
void shortcut(CLI::App& app, Options& o, const std::string& name, const std::string& key, const std::string& type,
              const std::string& doc);
/// --set, as often as there are keys; and --threads.
void add_sets(CLI::App& app, Options& o, const std::string& doc);
void add_threads(CLI::App& app, Options& o);

/// `sphk study` with its options.
void add_study(CLI::App& root, Options& o);

}  // namespace sphk
