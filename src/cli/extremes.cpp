// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>

#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"
#include "src/study/extreme_table.hpp"

namespace sphk {

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

}  // namespace sphk
