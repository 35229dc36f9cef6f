// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"

namespace sphk {

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

}  // namespace sphk
