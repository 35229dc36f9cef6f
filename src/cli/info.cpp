// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"
#include "src/engine/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/info.hpp"
#include "src/io/input_file.hpp"
#include "src/report/final_table.hpp"
#include "src/report/run_json.hpp"
#include "src/stability/limits.hpp"

namespace sphk {

namespace {

/// What a run of this folder came to, as it was told at its end.
std::string run_info(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "run.json";
  if (!std::filesystem::exists(file))
    throw InputError(
        fmt::format("{} holds no run.json: it is no run's folder, or the run has not ended yet", folder.string()));
  require_file(file);
  const RunRecord r = read_run_json(text_of_file(file), file.string());
  return fmt::format("{}: {} with {} particles in {}D; scheme {}, kernel {}, {:g} neighbours\n{} at t = {:g}\n\n{}",
                     folder.string(), r.scene, r.particles, r.dimension, r.scheme, r.kernel, r.neighbours,
                     r.finished ? "complete" : "not complete", r.time, final_table(r));
}

}  // namespace

void add_info(CLI::App& root, Options& o) {
  CLI::App& info = *root.add_subcommand("info", "what an HDF5 file holds, or what a run came to");
  info.add_option("file", o.what, "a snapshot, an initial condition or a run's folder")->required();
  acts(info, o, [&o] {
    const auto limits = [](const ParticleSet& gas) { return limit_remarks(contrasts(gas), {}); };
    fmt::print("{}\n", std::filesystem::is_directory(o.what) ? run_info(o.what) : file_info(o.what, limits));
    return ExitCode::done;
  });
}

}  // namespace sphk
