// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstring>
#include <memory>

#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"
#include "src/engine/errors.hpp"
#include "src/run/platform.hpp"
#include "src/schemes/modules.hpp"

namespace sphk {

namespace {

/// --module FILE, of every command, and SPHK_MODULE_PATH.
void add_modules(CLI::App& root) {
  CLI::Option* option = root.add_option_function<std::vector<std::string>>(
      "--module", [](const std::vector<std::string>& files) { add_to_module_path(files); },
      "a shared object with a scheme, smoothing kernel or scene of one's own; as often as there are; those of the "
      "environment's SPHK_MODULE_PATH (files and folders, a colon between) come first");
  option->type_name("FILE")->allow_extra_args(false)->take_all();
  for (CLI::App* command : root.get_subcommands([](const CLI::App*) { return true; })) command->fallthrough();
}

/// The parser's message, the nearest option or command to each word that is none, and where the help is.
std::string explain(const CLI::App& root, const CLI::ParseError& error, int argc, char** argv) {
  const CLI::App* app = &root;
  while (!app->get_subcommands().empty()) app = app->get_subcommands().front();
  Settings known;
  std::vector<const CLI::Option*> all = app->get_options();
  all.push_back(root.get_option("--module"));
  for (const CLI::Option* option : all)
    for (const std::string& name : option->get_lnames())
      if (!known.has("--" + name)) known.declare({.name = "--" + name, .value = false, .doc = "", .choices = {}});
  for (const CLI::App* command : app->get_subcommands([](const CLI::App*) { return true; }))
    known.declare({.name = command->get_name(), .value = false, .doc = "", .choices = {}});
  std::string hint;
  for (int k = 1; k < argc; ++k) {
    const std::string word(argv[k], std::find(argv[k], argv[k] + std::strlen(argv[k]), '='));
    const bool named = std::string(error.what()).find(word) != std::string::npos;
    const bool command = app == &root && k == 1;
    if (known.has(word) || !(command || (named && word.starts_with("--")))) continue;
    if (const std::string nearest = known.nearest(word); !nearest.empty())
      hint += fmt::format("\n  {}: did you mean {}?", word, nearest);
  }
  const std::string help = app == &root ? "sphk --help" : fmt::format("sphk {} --help", app->get_name());
  return fmt::format("{}{}\nSee: {}", error.what(), hint, help);
}

}  // namespace

Request parse_command_line(int argc, char** argv) {
  const auto options = std::make_shared<Options>();
  CLI::App root("sphk: smoothed-particle hydrodynamics for compressible gas", "sphk");
  root.set_version_flag("--version", version_text());
  root.require_subcommand(1);
  for (const auto add : {add_run, add_list, add_show, add_info, add_ic, add_plot, add_movie, add_rates, add_stability,
                         add_study, add_gallery, add_extremes, add_tables})
    add(root, *options);
  add_modules(root);
  root.footer(
      "Three commands from nothing to a picture:\n  sphk list\n  sphk run sod\n  sphk plot sod-run\n\n"
      "`sphk COMMAND --help` tells more about each command.");
  try {
    root.parse(argc, argv);
  } catch (const CLI::Success& done) {  // --help, --version
    const int code = root.exit(done);
    return {.act = [code] { return code; }};
  } catch (const CLI::ParseError& error) {
    throw InputError(explain(root, error, argc, argv));
  }
  load_modules();
  Request request = options->request;
  request.act = [options, act = request.act] { return act(); };
  return request;
}

}  // namespace sphk
