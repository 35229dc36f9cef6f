// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>

#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"
#include "src/study/gallery.hpp"

namespace sphk {

void add_gallery(CLI::App& root, Options& o) {
  CLI::App& app = add_batch(root, o, "gallery", "a small run of every scene, on one page", make_gallery);
  app.add_option("scenes", o.batch.names, "only these scenes");
  add_path(app, "--out", o.batch.out, "folder of the gallery; default: gallery");
  app.footer(
      "The folder gets index.html (one page, nothing beside it needed), gallery.png and the runs. It takes about two\n"
      "minutes on two cores.\nExamples:\n  sphk gallery\n  sphk gallery sod kh12 --out two");
}

}  // namespace sphk
