#include "src/run/stability_map.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
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

}  // namespace

std::string stability_text(const StabilityRequest& request) {
  const Lattice& lattice = find_lattice(request.lattice);
  check(request, lattice.dimension);
  const double h = support_of(request, lattice.dimension);
  std::string text = fmt::format(
      "{} with {:.4g} neighbours, h = {:.4g} spacings, on a {} lattice; gamma {:.4g}\n"
      "smallest omega^2/(k^2 c^2) for kappa up to pi over the spacing (R10 eq 40-43):\n\n",
      request.kernel, lattice_neighbours(h, lattice.dimension), h, lattice.name, request.gamma);
  const auto add = [&](const std::string& name, const std::string& l, const std::string& t, const std::string& r) {
    text += fmt::format("  {:<10} {:>13} {:>13}", name, l, t);
    text += lattice.basis.size() > 1 ? fmt::format(" {:>13}\n", r) : "\n";
  };
  const auto cell = [](double value) { return std::isfinite(value) ? fmt::format("{:+.2e}", value) : "-"; };
  add("direction", "longitudinal", "transverse", "relative");
  const Dispersion dispersion(lattice, request.kernel, h, request.gamma);
  WaveModes least;
  for (const WaveDirection& direction : wave_directions(lattice.dimension)) {
    const WaveModes slowest = slowest_waves(dispersion, direction.k, 400);
    add(direction.name, cell(slowest.longitudinal), cell(slowest.transverse), cell(slowest.relative));
    least = slower(least, slowest);
  }
  return text + fmt::format(
                    "\n{}: the least is {:+.2e}; below {:g} particles leave the lattice\n"
                    "stable neighbour numbers: {}\n",
                    least.least() >= unstable_below ? "stable" : "unstable", least.least(), unstable_below,
                    stable_numbers(request, lattice));
}

void write_stability_map(const StabilityRequest& request) {
  constexpr int rows = 64, columns = 48;
  const Lattice& lattice = find_lattice(request.lattice);
  const Range range = supports_of_interest(lattice.dimension);
  Json panels = Json::array();
  std::string csv = "direction,h,neighbours,kappa,longitudinal,transverse,relative\n";
  for (const auto& [name, k] : wave_directions(lattice.dimension)) {
    Json panel = {{"direction", name}, {"longitudinal", {}}, {"transverse", {}}};
    for (int i = 0; i < rows; ++i) {
      const double h = range.from + (i + 0.5) / rows * (range.to - range.from);
      const Dispersion dispersion(lattice, request.kernel, h, request.gamma);
      Json longitudinal, transverse;
      for (int j = 0; j < columns; ++j) {
        const double kappa = std::numbers::pi * (j + 0.5) / columns;
        const WaveModes modes = dispersion.at({kappa * k[0], kappa * k[1], kappa * k[2]});
        csv += fmt::format("\"{}\",{:.6g},{:.6g},{:.6g},{:.9g},{:.9g},{:.9g}\n", name, h,
                           lattice_neighbours(h, lattice.dimension), kappa, modes.longitudinal, modes.transverse,
                           modes.relative);
        longitudinal.push_back(modes.longitudinal), transverse.push_back(modes.transverse);
      }
      panel["longitudinal"].push_back(longitudinal), panel["transverse"].push_back(transverse);
    }
    panels.push_back(panel);
  }
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
