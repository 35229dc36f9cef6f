// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"

namespace sphk {

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

}  // namespace sphk
