// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/extreme_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "src/engine/errors.hpp"
#include "src/engine/hint.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/io/reader.hpp"
#include "src/report/history.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

/// Columns that no run may spoil.
constexpr const char* columns[] = {"Coordinates",      "Velocities", "Masses",   "Densities",
                                   "InternalEnergies", "Pressures",  "Entropies"};

fs::path last_snapshot(const FinishedRun& run) {
  return run.folder / "snap_0001.hdf5";
}

/// Of the last snapshot, and of the extremes that the history keeps.
Quantity unsound_numbers(const FinishedRun& run) {
  Quantity unsound;
  const auto look_at = [&](double value, bool positive, const std::string& name, const std::string& place) {
    if (std::isfinite(value) && (!positive || value > 0)) return;
    if (unsound.value++ == 0) unsound.where = fmt::format("{} {:g} {}", name, value, place);
  };
  const hdf5::File file = hdf5::File::open(last_snapshot(run));
  const hdf5::Group gas = file.group("PartType0");
  for (const std::string name : columns) {
    const auto values = gas.dataset(name).read<double>();
    const bool positive = name != "Coordinates" && name != "Velocities";
    for (std::size_t k = 0; k < values.size(); ++k) look_at(values[k], positive, name, fmt::format("at row {}", k));
  }
  for (const HistoryRow& row : read_history(run.folder / "history.csv"))
    for (const auto& [name, value] : row)
      look_at(value, name.starts_with("min_"), name, fmt::format("at t = {:g}", row.at("time")));
  return unsound;
}

/// A shock is as wide as a support. It is where the density, from the right, first passes the mean of both sides.
double front_distance(const FinishedRun& run) {
  const auto exact = run.scene.exact(run.settings);
  if (!exact) throw InputError(fmt::format("{} has no exact solution that tells where its front is", run.scene.name()));
  const ParticleSet gas = read_particles(last_snapshot(run)).particles;
  const std::vector<double> rho =
      hdf5::File::open(last_snapshot(run)).group("PartType0").dataset("Densities").read<double>();
  const PlotHint hint = run.scene.plot_hint(run.settings);
  const double ahead = exact({hint.to, 0, 0}, gas.time).rho;
  double place = hint.to;
  const double step = 1e-5 * (hint.to - hint.from);
  while (place > hint.from && std::abs(exact({place, 0, 0}, gas.time).rho / ahead - 1) < 0.01) place -= step;
  const double middle = std::sqrt(ahead * exact({place - 10 * step, 0, 0}, gas.time).rho);
  double found = hint.from, first_ahead = hint.to, h = 1;
  for (std::size_t i = 0; i < gas.size(); ++i)
    if (gas.x[i][0] < hint.to && gas.x[i][0] > found && rho[i] > middle) found = gas.x[i][0];
  for (std::size_t i = 0; i < gas.size(); ++i)
    if (gas.x[i][0] > std::max(found, place) && gas.x[i][0] < first_ahead && rho[i] < 1.1 * ahead)
      first_ahead = gas.x[i][0], h = gas.h[i];
  return std::abs(found - place) / h;
}

double pairs_of_an_update(const FinishedRun& run) {
  std::ifstream file(run.folder / "run.json");
  const auto json = nlohmann::json::parse(file);
  return json["pair_interactions"].get<double>() / (json["updates"].get<double>() * json["neighbours"].get<double>());
}

}  // namespace

Quantity quantity_of(const std::string& name, const FinishedRun& run) {
  if (name == "unsound") return unsound_numbers(run);
  if (name == "front") return {front_distance(run), ""};
  if (name == "pairs") return {pairs_of_an_update(run), ""};
  const HistoryRow row = read_history(run.folder / "history.csv").back();
  for (const std::string& column : {name, name + "_drift"})
    if (row.contains(column)) return {row.at(column), ""};
  Settings known;
  for (const std::string one : {"unsound", "threads", "front", "pairs", "energy", "momentum", "angular_momentum"})
    known.declare({.name = one, .value = 0.0, .doc = "", .choices = {}});
  for (const auto& [one, value] : row) known.declare({.name = one, .value = 0.0, .doc = "", .choices = {}});
  throw InputError(
      fmt::format("no number \"{}\"; {}", name, hint(known.nearest(name), "columns of history.csv are numbers")));
}

double difference(const fs::path& one, const fs::path& other) {
  const hdf5::File a = hdf5::File::open(one), b = hdf5::File::open(other);
  const hdf5::Group gas_a = a.group("PartType0"), gas_b = b.group("PartType0");
  double largest = 0;
  for (const char* name : columns) {
    const auto x = gas_a.dataset(name).read<double>(), y = gas_b.dataset(name).read<double>();
    double scale = 0, off = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!std::isfinite(x[i] - y[i])) return std::numeric_limits<double>::infinity();
      scale = std::max(scale, std::abs(x[i])), off = std::max(off, std::abs(x[i] - y[i]));
    }
    if (off > 0) largest = std::max(largest, off / scale);
  }
  return largest;
}

}  // namespace sphk
