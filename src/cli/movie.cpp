// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/movie.hpp"

#include <CLI/CLI.hpp>

#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"

namespace sphk {

void add_movie(CLI::App& root, Options& o) {
  CLI::App& app = *root.add_subcommand("movie", "a film of runs, side by side, on one scale of colours");
  app.add_option("runs", o.movie.what, "folders of runs")->required();
  add_field_view(app, o.movie.view, "the field that is shown; default: rho");
  app.add_option("--out", o.movie.out, "the film: .mp4 (needs ffmpeg), .gif, or .html, a page with the pictures in it")
      ->required()
      ->type_name("FILE");
  app.add_option("--fps", o.movie.fps, "pictures a second; default: 24")->check(CLI::Range(0.1, 240.0));
  app.add_option("--every", o.movie.every, "show every K-th snapshot, and the last")
      ->check(CLI::Range(1, 1000000))
      ->type_name("K");
  app.footer(
      "A run leaves more snapshots with --set output.snapshots=N.\n\nExamples:\n"
      "  sphk run kh12 --set output.snapshots=100\n  sphk movie kh12-run --out kh.mp4\n"
      "  sphk movie kh12-run kh12-run-2 --field A --range 0.5,2 --out both.mp4 --fps 30\n"
      "  sphk movie blob-run --log --column --every 2 --out cloud.gif");
  computes(app, o, [&o] {
    make_movie(o.movie);
    return ExitCode::done;
  });
}

}  // namespace sphk
