// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "kernels/smoothing/list.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"
#include "src/io/atomic_file.hpp"
#include "src/report/plot_script.hpp"
#include "src/tables/published.hpp"

namespace sphk {

namespace {

/// S12 Fig. 1 for kernels of the papers: W h^3 and its derivative over r/h in 3D, with half-mass radii.
void draw_kernels(const std::filesystem::path& folder) {
  nlohmann::ordered_json kernels = nlohmann::ordered_json::array();
  for (const char* name : {"cs", "ct", "hoct4", "liq", "wc6"}) {
    nlohmann::ordered_json one = {{"name", name}, {"half_mass", half_mass_radius(name)}};
    with_kernel(name, [&](const auto& k) {
      for (int i = 0; i <= 400; ++i) {
        const double q = i / 400.0;
        const auto shape = k(q);
        one["q"].push_back(q), one["W"].push_back(k.norm(3) * shape.w), one["dW"].push_back(k.norm(3) * shape.dw);
      }
      return 0;
    });
    kernels.push_back(one);
  }
  run_plot_script(nlohmann::ordered_json{{"kernels", kernels}, {"out", (folder / "kernels.png").string()}}.dump());
}

int tables_command(const std::optional<std::filesystem::path>& folder) {
  if (folder) std::filesystem::create_directories(*folder);
  std::size_t values = 0, agreeing = 0;
  for (const auto make : {+[] { return density_errors(32); }, hoct_parameters, liq_coefficients, half_mass_radii}) {
    const PublishedTable table = make();
    fmt::print("{}\n", table.text());
    values += table.values.size();
    agreeing += static_cast<std::size_t>(std::ranges::count_if(table.values, &PublishedValue::agrees));
    if (folder) write_atomically(*folder / (table.key + ".csv"), table.csv());
  }
  fmt::print("{} of {} printed values agree within half a unit of their last digit; * marks the others\n", agreeing,
             values);
  if (folder) draw_kernels(*folder);
  return ExitCode::done;
}

}  // namespace

void add_tables(CLI::App& root, Options& o) {
  CLI::App& app = *root.add_subcommand("tables", "the papers' tables, computed, beside what they print");
  add_threads(app, o.threads);
  add_path(app, "--out", o.tables_folder, "folder for the tables as CSV and the smoothing kernels as kernels.png");
  app.footer(
      "S12 Table 1 (density errors), R10 Table 1 (HOCT kernels), V10 Table 1 (LIQ kernels), S12 Fig. 1 (half-mass "
      "radii).\nExample:\n  sphk tables --out tables");
  computes(app, o, [&o] { return tables_command(o.tables_folder); });
}

}  // namespace sphk
