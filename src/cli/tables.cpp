#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "kernels/smoothing/list.hpp"
#include "src/cli/commands.hpp"
#include "src/io/atomic_file.hpp"
#include "src/report/plot_script.hpp"
#include "src/tables/published.hpp"

namespace sphk {

namespace {

void print(const PublishedTable& table) {
  fmt::print("{}\n  {:<16} {:<17} {:>9} {:>12} {:>11}\n", table.title, "", "", "printed", "computed", "difference");
  std::string last;
  for (const PublishedValue& v : table.values) {
    fmt::print("  {:<16} {:<17} {:>9} {:>12.5g} {:>+11.1e}{}\n", v.row == last ? "" : v.row, v.quantity, v.printed,
               v.computed, v.difference(), v.agrees() ? "" : "  *");
    last = v.row;
  }
  if (!table.note.empty()) fmt::print("  {}\n", table.note);
  fmt::print("\n");
}

void write_csv(const std::filesystem::path& folder, const PublishedTable& table) {
  std::string csv = "row,quantity,printed,computed,difference,agrees\n";
  for (const PublishedValue& v : table.values)
    csv += fmt::format("\"{}\",\"{}\",{},{:.10g},{:.3g},{}\n", v.row, v.quantity, v.printed, v.computed, v.difference(),
                       v.agrees() ? "yes" : "no");
  write_atomically(folder / (table.key + ".csv"), csv);
}

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

}  // namespace

int tables_command(const TablesOptions& options) {
  if (options.out) std::filesystem::create_directories(*options.out);
  std::size_t values = 0, agreeing = 0;
  for (const auto make : {+[] { return density_errors(32); }, hoct_parameters, liq_coefficients, half_mass_radii}) {
    const PublishedTable table = make();
    print(table);
    for (const PublishedValue& v : table.values) ++values, agreeing += v.agrees();
    if (options.out) write_csv(*options.out, table);
  }
  fmt::print("{} of {} printed values agree within half a unit of their last digit; * marks the others\n", agreeing,
             values);
  if (options.out) draw_kernels(*options.out);
  return ExitCode::done;
}

}  // namespace sphk
