// SPDX-License-Identifier: BSD-3-Clause
#include "src/tables/published.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernels/smoothing/list.hpp"
#include "src/scenes/block.hpp"
#include "src/scenes/mass_profile.hpp"
#include "src/schemes/registry.hpp"

namespace sphk {

double half_last_digit(const std::string& printed) {
  const auto point = printed.find('.');
  const auto decimals = point == std::string::npos ? 0 : double(printed.size() - point - 1);
  return 0.5 * std::pow(10.0, -decimals);
}

std::string PublishedTable::text() const {
  std::string text =
      fmt::format("{}\n  {:<16} {:<17} {:>9} {:>12} {:>11}\n", title, "", "", "printed", "computed", "difference");
  std::string last;
  for (const PublishedValue& v : values) {
    text += fmt::format("  {:<16} {:<17} {:>9} {:>12.5g} {:>+11.1e}{}\n", v.row == last ? "" : v.row, v.quantity,
                        v.printed, v.computed, v.difference(), v.agrees() ? "" : "  *");
    last = v.row;
  }
  return note.empty() ? text : text + "  " + note + "\n";
}

std::string PublishedTable::csv() const {
  std::string csv = "row,quantity,printed,computed,difference,agrees\n";
  for (const PublishedValue& v : values)
    csv += fmt::format("\"{}\",\"{}\",{},{:.10g},{:.3g},{}\n", v.row, v.quantity, v.printed, v.computed, v.difference(),
                       v.agrees() ? "yes" : "no");
  return csv;
}

namespace {

/// Densities that the kernel measures on that arrangement of unit density, in ascending order.
std::vector<double> measured_densities(const std::string& kernel, double neighbours, const std::string& arrangement,
                                       int n) {
  ParticleSet gas = even_gas({.counts = even_counts(3, n)}, arrangement);
  gas.u.assign(gas.size(), 1.0);
  SimulationSettings settings;
  settings.kernel = kernel;
  settings.neighbours = neighbours;
  std::vector<double> rho = make_simulation(gas, settings)->snapshot().field("Densities").values;
  std::ranges::sort(rho);
  return rho;
}

template <int n>
void append_hoct(std::vector<PublishedValue>& values, const std::vector<std::string>& printed) {
  using K = Hoct<n>;
  const double computed[] = {K::A, K::B, K::P, K::Q, K::kappa, K{}.norm(3)};
  const char* names[] = {"A", "B", "P", "Q", "alpha", "N"};
  for (std::size_t k = 0; k < printed.size(); ++k)
    values.push_back({fmt::format("n = {}", n), names[k], printed[k], computed[k]});
}

}  // namespace

PublishedTable density_errors(int n) {
  struct Row {
    const char* kernel;
    int neighbours;
    const char* printed[2][3];  ///< cubic, glass
  };
  const Row rows[] = {{"cs", 32, {{"1.00", "1.00", "1.00"}, {"1.02", "1.01", "1.01"}}},
                      {"cs", 128, {{"1.00", "1.00", "1.00"}, {"1.01", "1.00", "0.996"}}},
                      {"ct", 32, {{"1.07", "1.07", "1.07"}, {"1.08", "1.07", "1.06"}}},
                      {"ct", 128, {{"1.02", "1.02", "1.02"}, {"1.02", "1.02", "1.01"}}},
                      {"hoct4", 442, {{"1.01", "1.01", "1.01"}, {"1.02", "1.01", "1.00"}}}};
  PublishedTable table{
      "s12-table-1",
      fmt::format("S12 Table 1: densities measured where rho = 1 ({}^3 particles)", n),
      "S12's column \"5 per cent\" is the high end, the 95th percentile here. Its glass is another one.",
      {}};
  for (const Row& row : rows)
    for (const int glass : {0, 1}) {
      const std::vector<double> rho = measured_densities(row.kernel, row.neighbours, glass ? "glass" : "cubic", n);
      const double fractions[] = {0.95, 0.5, 0.05};
      for (int k = 0; k < 3; ++k)
        table.values.push_back({fmt::format("{} {} {}", row.kernel, row.neighbours, glass ? "glass" : "simple"),
                                fmt::format("rho, {:g} %", 100 * fractions[k]), row.printed[glass][k],
                                rho[std::size_t(fractions[k] * double(rho.size() - 1) + 0.5)]});
    }
  return table;
}

PublishedTable hoct_parameters() {
  PublishedTable table{"r10-table-1", "R10 Table 1: parameters of the HOCT kernels", "", {}};
  append_hoct<3>(table.values, {"2.4", "-9.4", "-1.81", "1.028", "0.317", "3.71"});
  append_hoct<4>(table.values, {"3.2", "-18.8", "-2.15", "0.98", "0.214", "6.52"});
  append_hoct<5>(table.values, {"4.27", "-37.6", "-2.56", "0.962", "0.161", "10.4"});
  append_hoct<8>(table.values, {"10.1", "-300.8", "-3.86", "0.942", "0.0927", "30.75"});
  return table;
}

PublishedTable liq_coefficients() {
  struct Row {
    double x_s;
    const char* printed[8];  ///< A to F, N_2D, N_3D
  };
  const Row rows[] = {{0, {"-0.5", "1", "0", "-1", "0.5", "0.5", "4.775", "6.685"}},
                      {0.2, {"-0.9766", "2.344", "-1.172", "-0.7813", "0.5859", "0.6", "3.490", "4.753"}},
                      {0.3, {"-1.458", "3.790", "-2.624", "-0.2915", "0.5831", "0.6500", "2.962", "3.947"}},
                      {0.4, {"-2.315", "6.481", "-5.556", "0.9259", "0.4630", "0.7", "2.508", "3.251"}},
                      {0.6, {"-7.813", "25", "-28.125", "12.5", "-1.563", "0.8", "1.798", "2.168"}},
                      {0.8, {"-62.5", "225", "-300", "175", "-37.5", "0.9", "1.300", "1.434"}}};
  const char* names[] = {"A", "B", "C", "D", "E", "F", "N 2D", "N 3D"};
  PublishedTable table{"v10-table-1",
                       "V10 Table 1: coefficients of the LIQ kernels",
                       "E of x_s = 0 is printed as \"05\", read here as 0.5; N 3D of x_s = 0.3 is cut, not rounded.",
                       {}};
  for (const Row& row : rows) {
    // The engine's form outside the core is s^3 (c + k s), s = 1 - q: expanded in q.
    const Liq liq(row.x_s);
    const double c = liq.cubic, k = liq.quartic;
    const double computed[] = {k,     -c - 4 * k, 3 * c + 6 * k, -3 * c - 4 * k,
                               c + k, liq.w(0.0), liq.norm(2),   liq.norm(3)};
    for (int i = 0; i < 8; ++i)
      table.values.push_back({fmt::format("x_s = {:g}", row.x_s), names[i], row.printed[i], computed[i]});
  }
  return table;
}

double half_mass_radius(const std::string& kernel) {
  return with_kernel(kernel, [](const auto& k) {
    return MassProfile([&](double q) { return q * q * k.w(q); }, 0, 1, 200000).place(0.5);
  });
}

PublishedTable half_mass_radii() {
  using K = Hoct<4>;
  const double cs = half_mass_radius("cs"), ct = half_mass_radius("ct"), hoct = half_mass_radius("hoct4");
  return {"s12-figure-1",
          "S12 Fig. 1 and eq 17: kernels and half-mass radii in 3D",
          fmt::format("Radii in units of h: CS {:.4f}, CT {:.4f}, HOCT4 {:.4f}. CS and CT overlap on S12's plot; its "
                      "\"~240\" neighbours of CS as wide as 442 of HOCT4 is a round number.",
                      cs, ct, hoct),
          {{"hoct4", "N", "6.515", K{}.norm(3)},
           {"hoct4", "P", "-2.15", K::P},
           {"hoct4", "Q", "0.981", K::Q},
           {"hoct4", "kappa", "0.214", K::kappa},
           {"ct over cs", "half-mass radius", "1.0", ct / cs},
           {"cs as hoct4 442", "neighbours", "240", 442 * std::pow(hoct / cs, 3)}}};
}

}  // namespace sphk
