// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "src/cli/command_line.hpp"
#include "src/run/failure.hpp"
#include "src/run/movie.hpp"
#include "src/run/plot.hpp"
#include "src/run/rates.hpp"
#include "src/run/run.hpp"
#include "src/run/stability_map.hpp"
#include "src/study/child.hpp"
#include "src/study/study.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace sphk {

struct RunOptions {
  RunRequest request;
  bool dry_run = false, json_log = false;
};

/// Everything the options write to, and what the command then does; lives as long as the request.
struct Options {
  Request request;
  std::string what;                ///< a scene, a scene file or an HDF5 file
  std::vector<std::string> names;  ///< what `sphk study` is given: one, or the word compare and two
  std::vector<std::string> sets;
  std::vector<Override> shortcuts;
  int threads = 0;
  RunOptions run;
  PlotRequest plot;
  MovieRequest movie;
  RatesRequest rates;
  StabilityRequest stability;
  StudyRequest study;
  Batch batch;
  std::optional<std::filesystem::path> tables_folder;
};

/// The shortcuts and the --set options, in that order. Throws InputError.
std::vector<Override> overrides(const Options& o);

/// What a command does once its options are read: on Kokkos, or without it.
void computes(CLI::App& app, Options& o, const std::function<int()>& act);
void acts(CLI::App& app, Options& o, const std::function<int()>& act);

/// An option that is short for `--set key=...`.
void shortcut(CLI::App& app, Options& o, const std::string& name, const std::string& key, const std::string& type,
              const std::string& doc);
/// An option with a path, which must not be empty.
CLI::Option* add_path(CLI::App& app, const std::string& name, std::optional<std::filesystem::path>& path,
                      const std::string& doc);
/// Lets an option come often, with one value each.
void repeats(CLI::Option* option, const std::string& type);
/// --set, as often as there are keys; and --threads.
void add_sets(CLI::App& app, Options& o, const std::string& doc);
void add_threads(CLI::App& app, int& threads);
/// --scheme, --kernel, --neighbours, --precision and --set.
void add_physics(CLI::App& app, Options& o);
/// --field, --range, --log, --window, --slice, --column and --pixels.
void add_field_view(CLI::App& app, FieldView& view, const std::string& field_doc);
/// A command that makes many runs, each a process of its own.
CLI::App& add_batch(CLI::App& root, Options& o, const std::string& name, const std::string& doc,
                    const std::function<bool(const Batch&)>& make);

}  // namespace sphk
