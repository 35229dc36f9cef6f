// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>

#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"

namespace sphk {

void add_plot(CLI::App& root, Options& o) {
  CLI::App& app = *root.add_subcommand("plot", "draw a run or a snapshot");
  app.add_option("what", o.plot.what, "a run's folder, or one of its snapshots; several: their maps in one figure")
      ->required();
  app.add_flag("--exact,!--no-exact", o.plot.exact, "draw the exact solution where the scene has one (default)");
  app.add_flag("--conservation", o.plot.conservation, "draw how well the runs conserve, in one figure");
  app.add_flag("--errors", o.plot.errors,
               "draw density, particles, |E0| and P of runs with output.errors = true, in one figure (R10 Fig. 4)");
  app.add_option("--profile", o.plot.profile,
                 "draw this field along the scene's own coordinate, a panel a run (V10 Fig. 4)")
      ->type_name("FIELD");
  add_field_view(app, o.plot.view, "draw this field of the runs as maps on one scale of colours");
  app.add_flag("--all", o.plot.every, "draw every snapshot of the folder, not only the last, on one scale");
  add_path(app, "--out", o.plot.out,
           "name of the figure (.png, .pdf, .svg, .jpg), or a folder; default: beside the snapshots");
  app.footer(
      "Fields: rho, P, u, A, m, h, alpha, div_v, v_x, v_y, v_z, and about the scene's centre v_R, v_phi (cylindrical), "
      "v_r\n(spherical), |v|; E0_x, ... of runs with output.errors = true; any dataset of the snapshot by its name.\n\n"
      "Examples:\n  sphk plot sod-run\n  sphk plot sod-run/snap_0005.hdf5 --out sod.pdf\n"
      "  sphk plot blob-run blob-run-2 --out both.png\n"
      "  sphk plot kh12-run --field v_y --range -0.3,0.3\n"
      "  sphk plot kh18-run --field alpha --all --out frames/\n"
      "  sphk plot blob-run --field rho --log --column --out cloud.pdf\n"
      "  sphk plot kh12-run --field A --window 0.2,0.5,0.1,0.4 --pixels 1024\n"
      "  sphk plot sod-run gresho-run --conservation --out conserved.png\n"
      "  sphk plot kh12-run kh12-run-2 --errors --out errors.png\n"
      "  sphk plot gresho-run --profile E0\n"
      "  sphk plot sod-run sod-run-2 sod-run-3 --profile rho --out tubes.png");
  computes(app, o, [&o] {
    plot(o.plot);
    return ExitCode::done;
  });
}

}  // namespace sphk
