#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"
#include "src/io/info.hpp"

namespace sphk {

void add_info(CLI::App& root, Options& o) {
  CLI::App& info = *root.add_subcommand("info", "what an HDF5 file holds");
  info.add_option("file", o.what, "a snapshot or an initial condition")->required();
  acts(info, o, [&o] {
    fmt::print("{}\n", file_info(o.what));
    return ExitCode::done;
  });
}

}  // namespace sphk
