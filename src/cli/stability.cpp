#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "kernels/smoothing/list.hpp"
#include "src/cli/commands.hpp"
#include "src/engine/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/report/plot_script.hpp"
#include "src/stability/dispersion.hpp"

namespace sphk {

namespace {

/// What is drawn and scanned: supports from one spacing to those of many neighbours.
struct Range {
  double from, to;
};
Range supports_of_interest(int dimension) {
  return {1.2, dimension == 1 ? 12.0 : dimension == 2 ? 8.0 : 5.5};
}

/// "24 to 52, 61 to 600": the neighbour numbers whose waves are all stable.
std::string stable_numbers(const StabilityOptions& o, const Lattice& lattice) {
  const Range h = supports_of_interest(lattice.dimension);
  const int first = static_cast<int>(std::ceil(lattice_neighbours(h.from, lattice.dimension))),
            last = static_cast<int>(lattice_neighbours(h.to, lattice.dimension));
  std::vector<std::string> ranges;
  int begin = 0;
  for (int n = first; n <= last + 1; ++n) {
    const bool stable =
        n <= last &&
        least_waves(lattice, o.kernel, lattice_support(n, lattice.dimension), o.gamma, 32).least() >= unstable_below;
    if (stable && begin == 0) begin = n;
    if (!stable && begin > 0) {
      ranges.push_back(begin == n - 1 ? fmt::format("{}", begin) : fmt::format("{} to {}", begin, n - 1));
      begin = 0;
    }
  }
  return ranges.empty() ? fmt::format("none from {} to {}", first, last)
                        : fmt::format("{} (of {} to {})", fmt::join(ranges, ", "), first, last);
}

std::string cell(double value) {
  return std::isfinite(value) ? fmt::format("{:+.2e}", value) : "-";
}

/// The map over kappa and h, as CSV and PNG.
void write_map(const StabilityOptions& o, const Lattice& lattice, double h) {
  constexpr int rows = 64, columns = 48;
  const Range range = supports_of_interest(lattice.dimension);
  nlohmann::ordered_json panels = nlohmann::ordered_json::array();
  std::string csv = "direction,h,neighbours,kappa,longitudinal,transverse,relative\n";
  for (const WaveDirection& direction : wave_directions(lattice.dimension)) {
    nlohmann::ordered_json panel = {{"direction", direction.name}, {"longitudinal", {}}, {"transverse", {}}};
    for (int i = 0; i < rows; ++i) {
      const double support = range.from + (i + 0.5) / rows * (range.to - range.from);
      const Dispersion dispersion(lattice, o.kernel, support, o.gamma);
      std::vector<double> longitudinal, transverse;
      for (int j = 0; j < columns; ++j) {
        const double kappa = std::numbers::pi * (j + 0.5) / columns;
        const WaveModes modes = dispersion.at({kappa * direction.k[0], kappa * direction.k[1], kappa * direction.k[2]});
        fmt::format_to(std::back_inserter(csv), "\"{}\",{:.6g},{:.6g},{:.6g},{:.9g},{:.9g},{:.9g}\n", direction.name,
                       support, lattice_neighbours(support, lattice.dimension), kappa, modes.longitudinal,
                       modes.transverse, modes.relative);
        longitudinal.push_back(modes.longitudinal), transverse.push_back(modes.transverse);
      }
      panel["longitudinal"].push_back(longitudinal);
      panel["transverse"].push_back(transverse);
    }
    panels.push_back(panel);
  }
  std::filesystem::create_directories(*o.out);
  write_atomically(*o.out / "stability.csv", csv);
  run_plot_script(nlohmann::ordered_json{
      {"stability", panels},
      {"h", {range.from, range.to}},
      {"mark", h},
      {"title", fmt::format("{} on a {} lattice, gamma {:.4g}", o.kernel, lattice.name, o.gamma)},
      {"out", (*o.out / "stability.png").string()}}
                      .dump());
}

}  // namespace

int stability_command(const StabilityOptions& options) {
  const Lattice& lattice = find_lattice(options.lattice);
  const int D = lattice.dimension;
  try {
    with_kernel(options.kernel, [](const auto&) { return 0; });
  } catch (const std::invalid_argument& error) {
    throw InputError(error.what());
  }
  if (options.h <= 0 && options.neighbours <= 0)
    throw InputError(
        "how wide is the kernel? Give a neighbour number (--neighbours 442) or a support radius in spacings (--h)");
  const double h = options.h > 0 ? options.h : lattice_support(options.neighbours, D);
  if (!(h > 1 && h < widest_support))
    throw InputError(
        fmt::format("a support radius of {:.3g} spacings: --h lies between 1 and {:g} spacings, --neighbours "
                    "between {:.0f} and {:.0f} on this lattice",
                    h, widest_support, std::ceil(lattice_neighbours(1, D)), lattice_neighbours(widest_support, D)));
  fmt::print(
      "{} with {:.4g} neighbours, h = {:.4g} spacings, on a {} lattice; gamma {:.4g}\n"
      "smallest omega^2/(k^2 c^2) for kappa up to pi over the spacing (R10 eq 40-43):\n\n",
      options.kernel, lattice_neighbours(h, D), h, lattice.name, options.gamma);
  const bool relative = lattice.basis.size() > 1;
  fmt::print("  {:<10} {:>13} {:>13}{}\n", "direction", "longitudinal", "transverse",
             relative ? fmt::format(" {:>13}", "relative") : "");
  const Dispersion dispersion(lattice, options.kernel, h, options.gamma);
  for (const WaveDirection& direction : wave_directions(D)) {
    const WaveModes slowest = slowest_waves(dispersion, direction.k, 400);
    fmt::print("  {:<10} {:>13} {:>13}{}\n", direction.name, cell(slowest.longitudinal), cell(slowest.transverse),
               relative ? fmt::format(" {:>13}", cell(slowest.relative)) : "");
  }
  const double least = least_waves(lattice, options.kernel, h, options.gamma, 400).least();
  fmt::print("\n{}: the least is {:+.2e}; below {:g} particles leave the lattice\nstable neighbour numbers: {}\n",
             least >= unstable_below ? "stable" : "unstable", least, unstable_below, stable_numbers(options, lattice));
  if (options.out) write_map(options, lattice, h);
  return ExitCode::done;
}

}  // namespace sphk
