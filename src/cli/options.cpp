// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "src/engine/errors.hpp"
#include "src/run/stop_signal.hpp"

namespace sphk {

std::vector<Override> overrides(const Options& o) {
  std::vector<Override> all = o.shortcuts;
  for (const std::string& text : o.sets) {
    const auto equals = text.find('=');
    if (equals == std::string::npos)
      throw InputError(fmt::format("--set {}: write KEY=VALUE, such as --set sph.kernel=cs", text));
    all.push_back({text.substr(0, equals), text.substr(equals + 1), "--set " + text});
  }
  return all;
}

void computes(CLI::App& app, Options& o, const std::function<int()>& act) {
  app.callback([&o, act] { o.request = {act, true, o.threads}; });
}

void acts(CLI::App& app, Options& o, const std::function<int()>& act) {
  app.callback([&o, act] { o.request = {act}; });
}

void shortcut(CLI::App& app, Options& o, const std::string& name, const std::string& key, const std::string& type,
              const std::string& doc) {
  const std::string spelling = name.substr(0, name.find(','));
  app.add_option_function<std::string>(
         name,
         [&o, key, spelling](const std::string& text) {
           o.shortcuts.push_back({key, text, spelling + " " + text});
         },
         doc)
      ->type_name(type);
}

CLI::Option* add_path(CLI::App& app, const std::string& name, std::optional<std::filesystem::path>& path,
                      const std::string& doc) {
  const auto take = [&path, name](const std::string& text) {
    if (text.empty())
      throw InputError(fmt::format("{} \"\": a name is wanted; leave {} out for the usual one", name, name));
    path = text;
  };
  return app.add_option_function<std::string>(name, take, doc);
}

void repeats(CLI::Option* option, const std::string& type) {
  option->type_name(type)->type_size(1)->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_sets(CLI::App& app, Options& o, const std::string& doc) {
  repeats(app.add_option("--set", o.sets, doc + "; once for each key"), "KEY=VALUE");
}

void add_threads(CLI::App& app, int& threads) {
  app.add_option("--threads", threads, "threads on the CPU; default: what OpenMP gives")->check(CLI::Range(1, 65536));
}

void add_physics(CLI::App& app, Options& o) {
  shortcut(app, o, "--scheme", "sph.scheme", "NAME",
           "the scheme: sph, gadget2, tsph, sphs, ... or a label such as SPHS-HCT442 (key sph.scheme)");
  shortcut(app, o, "--kernel", "sph.kernel", "NAME", "the smoothing kernel: cs, ct, hoct4, wc2, ... (key sph.kernel)");
  shortcut(app, o, "--neighbours", "sph.neighbours", "N", "the neighbour number (key sph.neighbours)");
  shortcut(app, o, "--precision", "sph.precision", "mixed|double", "of the pair arithmetic (key sph.precision)");
  add_sets(app, o, "set a key of the scene file");
}

void add_field_view(CLI::App& app, FieldView& view, const std::string& field_doc) {
  const auto numbers = [&](const char* name, std::vector<double>& to, int count, const char* type, const char* doc) {
    app.add_option(name, to, doc)->delimiter(',')->expected(count)->type_name(type);
  };
  app.add_option("--field", view.field, field_doc)->type_name("FIELD");
  numbers("--range", view.range, 2, "LO,HI", "least and largest value that the scale shows");
  app.add_flag("--log", view.logarithmic, "a logarithmic scale");
  numbers("--window", view.map.window, 4, "X0,X1,Y0,Y1", "the part of the x-y plane that maps show; default: all");
  app.add_option("--slice", view.map.slice, "the height of the plane that maps of gas in 3D show; default: the middle")
      ->type_name("Z");
  app.add_flag("--column", view.map.column, "maps of gas in 3D show the integral along z in place of a plane");
  app.add_option("--pixels", view.map.pixels, "of maps, along the longer side; default: 512")
      ->check(CLI::Range(16, 16384))
      ->type_name("N");
}

CLI::App& add_batch(CLI::App& root, Options& o, const std::string& name, const std::string& doc,
                    const std::function<bool(const Batch&)>& make) {
  CLI::App& app = *root.add_subcommand(name, doc);
  add_threads(app, o.batch.threads);
  computes(app, o, [&o, make] {
    const bool all_well = make(o.batch);
    if (stop_requested()) return ExitCode::stopped;
    return all_well ? ExitCode::done : ExitCode::numerics;
  });
  return app;
}

}  // namespace sphk
