// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/stability_map.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "kernels/smoothing/list.hpp"
#include "src/engine/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/report/plot_script.hpp"
#include "src/stability/dispersion.hpp"

namespace sphk {

namespace {

using Json = nlohmann::ordered_json;

/// What is drawn and scanned: supports from one spacing to those of many neighbours.
struct Range {
  double from, to;
};
Range supports_of_interest(int dimension) {
  return {1.2, dimension == 1 ? 12.0 : dimension == 2 ? 8.0 : 5.5};
}

double support_of(const StabilityRequest& request, int dimension) {
  return request.h > 0 ? request.h : lattice_support(request.neighbours, dimension);
}

/// Throws what is wrong with a request for this lattice.
void check(const StabilityRequest& request, int dimension) {
  with_kernel(request.kernel, [](const auto&) { return 0; });
  if (request.h <= 0 && request.neighbours <= 0)
    throw InputError(
        "how wide is the kernel? Give a neighbour number (--neighbours 442) or a support radius in spacings (--h)");
  if (const double h = support_of(request, dimension); !(h > 1 && h < widest_support))
    throw InputError(fmt::format(
        "a support radius of {:.3g} spacings: --h lies between 1 and {:g} spacings, "
        "--neighbours between {:.0f} and {:.0f} on this lattice",
        h, widest_support, std::ceil(lattice_neighbours(1, dimension)), lattice_neighbours(widest_support, dimension)));
}

/// The waves of WaveModes, by the name that text and figure have for them, and that of their column.
struct WaveKind {
  const char *name, *column;
  double WaveModes::*value;
};
constexpr std::array kinds_of_waves{WaveKind{"longitudinal", "longitudinal", &WaveModes::longitudinal},
                                    WaveKind{"transverse", "transverse", &WaveModes::transverse},
                                    WaveKind{"transverse (z)", "transverse_z", &WaveModes::transverse_z},
                                    WaveKind{"relative", "relative", &WaveModes::relative}};

/// Those that a lattice can have.
std::vector<WaveKind> kinds_of(const Lattice& lattice) {
  std::vector<WaveKind> kinds{kinds_of_waves[0]};
  if (lattice.dimension > 1) kinds.push_back(kinds_of_waves[1]);
  if (lattice.dimension > 2) kinds.push_back(kinds_of_waves[2]);
  if (lattice.basis.size() > 1) kinds.push_back(kinds_of_waves[3]);
  return kinds;
}

/// "24 to 52, 61 to 600": the neighbour numbers whose waves are all stable.
std::string stable_numbers(const StabilityRequest& request, const Lattice& lattice) {
  const int D = lattice.dimension;
  const Range h = supports_of_interest(D);
  const int first = static_cast<int>(std::ceil(lattice_neighbours(h.from, D))),
            last = static_cast<int>(lattice_neighbours(h.to, D));
  std::vector<std::string> ranges;
  for (int n = first, begin = first; n <= last + 1; ++n) {
    if (n <= last &&
        least_waves(lattice, request.kernel, lattice_support(n, D), request.gamma, 32).least() >= unstable_below)
      continue;
    if (begin < n) ranges.push_back(begin == n - 1 ? fmt::format("{}", begin) : fmt::format("{} to {}", begin, n - 1));
    begin = n + 1;
  }
  return ranges.empty() ? fmt::format("none from {} to {}", first, last)
                        : fmt::format("{} (of {} to {})", fmt::join(ranges, ", "), first, last);
}

/// The waves of one direction over wave number (columns) and support radius (rows); their lines go into `csv`.
Json panel_of(const StabilityRequest& request, const Lattice& lattice, const WaveDirection& direction,
              std::string& csv) {
  constexpr int rows = 64, columns = 48;
  const Range range = supports_of_interest(lattice.dimension);
  Json panel = {{"direction", direction.name}, {"waves", Json::object()}};
  for (int i = 0; i < rows; ++i) {
    const double h = range.from + (i + 0.5) / rows * (range.to - range.from);
    const Dispersion dispersion(lattice, request.kernel, h, request.gamma);
    std::map<std::string, Json> row;
    for (int j = 0; j < columns; ++j) {
      const double kappa = std::numbers::pi * (j + 0.5) / columns;
      const WaveModes modes = dispersion.at({kappa * direction.k[0], kappa * direction.k[1], kappa * direction.k[2]});
      csv += fmt::format("\"{}\",{:.6g},{:.6g},{:.6g}", direction.name, h, lattice_neighbours(h, lattice.dimension),
                         kappa);
      for (const WaveKind& kind : kinds_of_waves) csv += fmt::format(",{:.9g}", modes.*kind.value);
      csv += "\n";
      for (const WaveKind& kind : kinds_of(lattice)) row[kind.name].push_back(modes.*kind.value);
    }
    for (const WaveKind& kind : kinds_of(lattice)) panel["waves"][kind.name].push_back(row[kind.name]);
  }
  return panel;
}

}  // namespace

std::string stability_text(const StabilityRequest& request) {
  const Lattice& lattice = find_lattice(request.lattice);
  check(request, lattice.dimension);
  const double h = support_of(request, lattice.dimension);
  std::string text = fmt::format(
      "{} with {:.4g} neighbours, h = {:.4g} spacings, on a {} lattice; gamma {:.4g}\n"
      "smallest omega^2/(k^2 c^2) for kappa up to pi over the spacing (R10 eq 40-43):\n\n",
      request.kernel, lattice_neighbours(h, lattice.dimension), h, lattice.name, request.gamma);
  const auto kinds = kinds_of(lattice);
  text += fmt::format("  {:<10}", "direction");
  for (const WaveKind& kind : kinds) text += fmt::format(" {:>15}", kind.name);
  text += "\n";
  const Dispersion dispersion(lattice, request.kernel, h, request.gamma);
  WaveModes least;
  for (const WaveDirection& direction : wave_directions(lattice.dimension)) {
    const WaveModes slowest = slowest_waves(dispersion, direction.k, 400);
    text += fmt::format("  {:<10}", direction.name);
    for (const WaveKind& kind : kinds) {
      const double value = slowest.*kind.value;
      text += fmt::format(" {:>15}", std::isfinite(value) ? fmt::format("{:+.2e}", value) : "-");
    }
    text += "\n";
    least = slower(least, slowest);
  }
  return text + fmt::format(
                    "\n{}: the least is {:+.2e}; below {:g} particles leave the lattice\n"
                    "stable neighbour numbers: {}\n",
                    least.least() >= unstable_below ? "stable" : "unstable", least.least(), unstable_below,
                    stable_numbers(request, lattice));
}

void write_stability_map(const StabilityRequest& request) {
  const Lattice& lattice = find_lattice(request.lattice);
  const Range range = supports_of_interest(lattice.dimension);
  Json panels = Json::array();
  std::string csv = "direction,h,neighbours,kappa";
  for (const WaveKind& kind : kinds_of_waves) csv += fmt::format(",{}", kind.column);
  csv += "\n";
  for (const WaveDirection& direction : wave_directions(lattice.dimension))
    panels.push_back(panel_of(request, lattice, direction, csv));
  std::filesystem::create_directories(*request.out);
  write_atomically(*request.out / "stability.csv", csv);
  const std::string title =
      fmt::format("{} on a {} lattice, gamma {:.4g}", request.kernel, lattice.name, request.gamma);
  run_plot_script(Json{{"stability", panels},
                       {"h", {range.from, range.to}},
                       {"mark", support_of(request, lattice.dimension)},
                       {"title", title},
                       {"out", (*request.out / "stability.png").string()}}
                      .dump());
}

}  // namespace sphk
