#include <CLI/CLI.hpp>

#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"

namespace sphk {

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

}  // namespace sphk
