#include "src/cli/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <sstream>

#include "src/cli/options.hpp"
#include "src/engine/errors.hpp"
#include "src/io/info.hpp"
#include "src/run/platform.hpp"
#include "src/run/stop_signal.hpp"
#include "src/study/extreme_table.hpp"
#include "src/study/gallery.hpp"

namespace sphk {

namespace {

/// 90, 1:30 or 0:01:30 in seconds.
double seconds_of(const std::string& text) {
  double seconds = 0;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ':');) {
    char* end = nullptr;
    const double value = std::strtod(part.c_str(), &end);
    if (part.empty() || *end != '\0' || !(value >= 0))
      throw InputError(fmt::format("--walltime {}: write seconds, M:S or H:M:S", text));
    seconds = 60 * seconds + value;
  }
  if (!(seconds > 0)) throw InputError(fmt::format("--walltime {}: a positive time is wanted", text));
  return seconds;
}

void add_physics(CLI::App& app, Options& o) {
  shortcut(app, o, "--scheme", "sph.scheme", "NAME",
           "the scheme: sph, gadget2, tsph, sphs, ... or a label such as SPHS-HCT442 (key sph.scheme)");
  shortcut(app, o, "--kernel", "sph.kernel", "NAME", "the smoothing kernel: cs, ct, hoct4, wc2, ... (key sph.kernel)");
  shortcut(app, o, "--neighbours", "sph.neighbours", "N", "the neighbour number (key sph.neighbours)");
  shortcut(app, o, "--precision", "sph.precision", "mixed|double", "of the pair arithmetic (key sph.precision)");
  add_sets(app, o, "set a key of the scene file");
}

void add_run(CLI::App& root, Options& o) {
  CLI::App& app = *root.add_subcommand("run", "run a scene, a scene file or an initial condition");
  RunRequest& request = o.run.request;
  CLI::Option* what =
      app.add_option("what", request.what, "a scene (`sphk list`), a scene file (*.toml) or an HDF5 initial condition");
  add_path(app, "--resume", request.resume, "go on with the run in this folder, from its newest checkpoint")
      ->type_name("DIR")
      ->excludes(what);
  add_physics(app, o);
  shortcut(app, o, "-n,--resolution", "scene.n", "N", "the scene's resolution, particles along the box (key scene.n)");
  shortcut(app, o, "--t-end", "time.end", "T", "end time in code units (key time.end)");
  shortcut(app, o, "--steps", "time.max_steps", "N", "stop after so many steps (key time.max_steps)");
  add_threads(app, o.threads);
  add_path(app, "--out", request.out,
           "folder of the results; default: SCENE-run, or SCENE-run-2, ... where that exists");
  app.add_option_function<std::string>(
         "--walltime", [&request](const std::string& text) { request.walltime = seconds_of(text); },
         "stop with a checkpoint before so much wall-clock time is over: seconds, M:S or H:M:S")
      ->type_name("TIME");
  app.add_flag("--overwrite", request.overwrite, "replace the run that the folder of --out holds");
  app.add_flag("--dry-run", o.run.dry_run, "tell memory, steps, output size and run time from a trial of three steps");
  app.add_flag("--json-log", o.run.json_log, "print one JSON object a line instead of text");
  app.footer(
      "Examples:\n  sphk run sod\n  sphk run gresho -n 64 --neighbours 128 --kernel hoct4\n"
      "  sphk run sedov --set scene.lattice=cubic --t-end 0.05 --out blast\n  sphk run my.toml --dry-run\n"
      "  sphk run galaxy.hdf5 --t-end 0.2\n\n"
      "The folder gets snapshots (snap_0000.hdf5, ...), history.csv, run.json and scene.used.toml.\n"
      "SIGTERM, SIGINT, SIGUSR1, a file named stop in the run's folder and --walltime end the step, leave a checkpoint "
      "and exit\nwith 75; SIGUSR2 leaves a checkpoint and goes on. `sphk run --resume DIR` continues bit by bit, on as "
      "many threads.\n"
      "Exit codes: 0 done, 2 bad input, 3 numerics, 4 device or memory, 75 stopped with a checkpoint.");
  computes(app, o, [&o, &request] {
    if (request.what.empty() && !request.resume) throw InputError("sphk run takes a scene or file, or --resume DIR");
    if (request.resume && (!o.shortcuts.empty() || !o.sets.empty() || request.out))
      throw InputError(
          "--resume goes on with the run as it is: of the other options only --threads, --walltime and "
          "--json-log go with it");
    request.overrides = overrides(o);
    return run_command(o.run);
  });
}

void add_plot(CLI::App& root, Options& o) {
  CLI::App& app = *root.add_subcommand("plot", "draw a run or a snapshot as PNG files");
  app.add_option("what", o.plot.what, "a run's folder, or one of its snapshots; several: their maps in one figure")
      ->required();
  app.add_flag("--exact,!--no-exact", o.plot.exact, "draw the exact solution where the scene has one (default)");
  app.add_flag("--conservation", o.plot.conservation, "draw how well the runs conserve, in one figure");
  app.add_flag("--errors", o.plot.errors,
               "draw density, particles, |E0| and P of runs with output.errors = true, in one figure (R10 Fig. 4)");
  app.add_option("--profile", o.plot.profile, "draw this field of several runs, a panel each (V10 Fig. 4)")
      ->check(CLI::IsMember({"rho", "v", "P", "u", "A"}));
  app.add_flag("--all", o.plot.every, "draw every snapshot of the folder, not only the last");
  add_path(app, "--out", o.plot.out, "name of the figure (FILE.png), or a folder; default: beside the snapshots");
  app.footer(
      "Examples:\n  sphk plot sod-run\n  sphk plot sod-run/snap_0005.hdf5 --out sod.png\n"
      "  sphk plot blob-run blob-run-2 --out both.png\n"
      "  sphk plot sod-run gresho-run --conservation --out conserved.png\n"
      "  sphk plot kh12-run kh12-run-2 --errors --out errors.png\n"
      "  sphk plot sod-run sod-run-2 sod-run-3 --profile rho --out tubes.png");
  acts(app, o, [&o] {
    plot(o.plot);
    return ExitCode::done;
  });
}

void add_rates(CLI::App& root, Options& o) {
  CLI::App& app = *root.add_subcommand("rates", "compute one right-hand side of a snapshot or initial condition");
  app.add_option("file", o.rates.file, "an HDF5 file")->required();
  add_physics(app, o);
  add_threads(app, o.threads);
  app.add_option("--out", o.rates.out, "the HDF5 file to write")->required();
  app.add_flag("--split", o.rates.split, "write each term apart as well");
  app.add_option("--alpha", o.rates.alpha,
                 "dissipation: auto (the switch without history for sphs, none for others), file (the field Alpha), or "
                 "a number for all particles")
      ->type_name("auto|file|NUMBER");
  app.footer(
      "Computes in double, unless --precision says otherwise.\nExample:\n"
      "  sphk rates snap_0003.hdf5 --scheme gadget2 --kernel cs --neighbours 42 --out rates.hdf5");
  computes(app, o, [&o] {
    o.rates.overrides = overrides(o);
    const RatesResult result = rates(o.rates);
    for (const std::string& warning : result.warnings) fmt::print("note: {}\n", warning);
    fmt::print("{}: {} fields of {} particles\n", o.rates.out.string(), result.fields, result.particles);
    return ExitCode::done;
  });
}

void add_stability(CLI::App& root, Options& o) {
  CLI::App& app =
      *root.add_subcommand("stability", "which waves a kernel and neighbour number keep on a lattice (R10)");
  app.add_option("--kernel", o.stability.kernel, "the smoothing kernel: cs, ct, hoct4, wc2, ...")->required();
  CLI::Option* count = app.add_option("--neighbours", o.stability.neighbours, "the neighbour number")->type_name("N");
  app.add_option("--h", o.stability.h, "the support radius in spacings, in place of a neighbour number")
      ->excludes(count);
  app.add_option("--lattice", o.stability.lattice, "cubic, bcc, fcc, hcp; in 2D square, hexagonal; in 1D line");
  app.add_option("--gamma", o.stability.gamma, "adiabatic index; 5/3 where it is not given")->type_name("GAMMA");
  add_path(app, "--out", o.stability.out, "folder for maps over wave number and h, stability.png and stability.csv");
  app.footer(
      "Examples:\n  sphk stability --kernel hoct4 --neighbours 442\n"
      "  sphk stability --kernel cs --neighbours 32 --lattice square --out maps");
  acts(app, o, [&o] {
    fmt::print("{}", stability_text(o.stability));
    if (o.stability.out) write_stability_map(o.stability);
    return ExitCode::done;
  });
}

/// A command that makes many runs, each a process of its own.
CLI::App& add_batch(CLI::App& root, Options& o, const std::string& name, const std::string& doc,
                    const std::function<bool(const Batch&)>& make) {
  CLI::App& app = *root.add_subcommand(name, doc);
  add_threads(app, o.batch.threads);
  acts(app, o, [&o, make] {
    const bool all_well = make(o.batch);
    if (stop_requested()) return ExitCode::stopped;
    return all_well ? ExitCode::done : ExitCode::numerics;
  });
  return app;
}

void add_gallery(CLI::App& root, Options& o) {
  CLI::App& app = add_batch(root, o, "gallery", "a small run of every scene, on one page", make_gallery);
  app.add_option("scenes", o.batch.names, "only these scenes");
  add_path(app, "--out", o.batch.out, "folder of the gallery; default: gallery");
  app.footer(
      "The folder gets index.html (one page, nothing beside it needed), gallery.png and the runs. It takes about two\n"
      "minutes on two cores.\nExamples:\n  sphk gallery\n  sphk gallery sod kh12 --out two");
}

void add_extremes(CLI::App& root, Options& o) {
  CLI::App& app = add_batch(root, o, "extremes", "stiff and extreme runs: what is required of each, and what came out",
                            make_extremes);
  app.add_option("cases", o.batch.names, "only these cases, or files of cases (*.toml)");
  add_path(app, "--out", o.batch.out, "folder of the runs and of extremes.txt; default: extremes");
  app.footer(
      "A file of cases has a list [[case]], each with name, scene, summary, keys under [case.set] and bounds under "
      "[case.require];\nthose that come with sphk are such files, in share/sphk/studies/extremes. Exit code 3 where a "
      "case fails.\nExamples:\n  sphk extremes\n  sphk extremes blast leblanc --out two\n  sphk extremes mine.toml");
}

void add_tables(CLI::App& root, Options& o) {
  CLI::App& app = *root.add_subcommand("tables", "the papers' tables, computed, beside what they print");
  add_threads(app, o.threads);
  add_path(app, "--out", o.tables_folder, "folder for the tables as CSV and the smoothing kernels as kernels.png");
  app.footer(
      "S12 Table 1 (density errors), R10 Table 1 (HOCT kernels), V10 Table 1 (LIQ kernels), S12 Fig. 1 (half-mass "
      "radii).\nExample:\n  sphk tables --out tables");
  computes(app, o, [&o] { return tables_command(o.tables_folder); });
}

void add_inspection(CLI::App& root, Options& o) {
  computes(*root.add_subcommand("list", "the scenes, with their size and rough cost"), o, list_command);
  CLI::App& show = *root.add_subcommand("show", "what a scene computes, and every key with its meaning");
  show.add_option("what", o.what, "a scene, a scene file or an initial condition")->required();
  add_physics(show, o);
  shortcut(show, o, "-n,--resolution", "scene.n", "N", "the scene's resolution (key scene.n)");
  show.footer("Example:\n  sphk show sod --kernel hoct4 --neighbours 442");
  computes(show, o, [&o] { return show_command(o.what, overrides(o)); });
  CLI::App& info = *root.add_subcommand("info", "what an HDF5 file holds");
  info.add_option("file", o.what, "a snapshot or an initial condition")->required();
  acts(info, o, [&o] {
    fmt::print("{}\n", file_info(o.what));
    return ExitCode::done;
  });
  CLI::App& ic = *root.add_subcommand("ic", "work with initial conditions");
  ic.require_subcommand(1);
  CLI::App& check = *ic.add_subcommand("check", "look for NaN, zero masses, duplicate ids, coincident particles, ...");
  check.add_option("file", o.what, "an HDF5 initial condition")->required();
  acts(check, o, [&o] { return ic_check_command(o.what); });
}

/// The parser's message, the nearest option or command to each word that is none, and where the help is.
std::string explain(const CLI::App& root, const CLI::ParseError& error, int argc, char** argv) {
  const CLI::App* app = &root;
  while (!app->get_subcommands().empty()) app = app->get_subcommands().front();
  Settings known;
  for (const CLI::Option* option : app->get_options())
    for (const std::string& name : option->get_lnames())
      if (!known.has("--" + name)) known.declare({.name = "--" + name, .value = false, .doc = "", .choices = {}});
  for (const CLI::App* command : app->get_subcommands([](const CLI::App*) { return true; }))
    known.declare({.name = command->get_name(), .value = false, .doc = "", .choices = {}});
  std::string hint;
  for (int k = 1; k < argc; ++k) {
    const std::string word(argv[k], std::find(argv[k], argv[k] + std::strlen(argv[k]), '='));
    const bool named = std::string(error.what()).find(word) != std::string::npos;
    const bool command = app == &root && k == 1;
    if (!known.has(word) && (command || (named && word.starts_with("--"))))
      hint += fmt::format("\n  {}: did you mean {}?", word, known.nearest(word));
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
  add_run(root, *options);
  add_inspection(root, *options);
  add_plot(root, *options);
  add_rates(root, *options);
  add_stability(root, *options);
  add_study(root, *options);
  add_gallery(root, *options);
  add_extremes(root, *options);
  add_tables(root, *options);
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
  Request request = options->request;
  request.act = [options, act = request.act] { return act(); };
  return request;
}

}  // namespace sphk
