// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"
#include "src/io/check.hpp"
#include "src/stability/limits.hpp"

namespace sphk {

namespace {

int ic_check_command(const std::string& file) {
  const ReadResult content = read_particles(file, NonFinite::keep);
  Verdict verdict = judge(content);
  if (const std::string doubt = dimension_in_doubt(content); !doubt.empty()) verdict.errors.push_back(doubt);
  if (verdict.errors.empty())
    for (const std::string& remark : limit_remarks(contrasts(content.particles), {})) verdict.notes.push_back(remark);
  fmt::print("{}: {} gas particles in {}D\n", file, content.particles.size(), content.particles.dimension);
  for (const std::string& note : verdict.notes) fmt::print("  note: {}\n", note);
  for (const std::string& error : verdict.errors) fmt::print("  error: {}\n", error);
  const bool sound = verdict.errors.empty();
  fmt::print("{}\n", sound ? "A run can start from it." : "No run can start from it: mend the errors above.");
  return sound ? ExitCode::done : ExitCode::bad_input;
}

}  // namespace

void add_ic(CLI::App& root, Options& o) {
  CLI::App& ic = *root.add_subcommand("ic", "work with initial conditions");
  ic.require_subcommand(1);
  CLI::App& check = *ic.add_subcommand("check", "look for NaN, zero masses, duplicate ids, coincident particles, ...");
  check.add_option("file", o.what, "an HDF5 initial condition")->required();
  acts(check, o, [&o] { return ic_check_command(o.what); });
}

}  // namespace sphk
