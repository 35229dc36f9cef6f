#include "src/cli/extreme_outcomes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "src/io/hdf5_file.hpp"
#include "src/io/reader.hpp"
#include "src/report/history.hpp"
#include "src/report/quantity.hpp"
#include "src/run/failure.hpp"
#include "src/run/problem.hpp"
#include "src/study/child.hpp"
#include "src/study/study_record.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

/// Columns that no run may spoil.
constexpr const char* columns[] = {"Coordinates",      "Velocities", "Masses",   "Densities",
                                   "InternalEnergies", "Pressures",  "Entropies"};

/// The last snapshot has numbers alone, positive ones where they must be; so have the extremes that the history keeps.
Outcome check_numbers(const fs::path& folder) {
  const hdf5::File file = hdf5::File::open(folder / "snap_0001.hdf5");
  const hdf5::Group gas = file.group("PartType0");
  for (const char* name : columns) {
    const auto values = gas.dataset(name).read<double>();
    const bool positive = std::string(name) != "Coordinates" && std::string(name) != "Velocities";
    const auto wrong =
        std::ranges::find_if(values, [&](double value) { return !std::isfinite(value) || (positive && !(value > 0)); });
    if (wrong != values.end())
      return {"finite, > 0", fmt::format("{} {:g} at row {}", name, *wrong, wrong - values.begin()), false};
  }
  for (const HistoryRow& row : read_history(folder / "history.csv"))
    for (const auto& [name, value] : row)
      if (!std::isfinite(value) || (name.starts_with("min_") && !(value > 0)))
        return {"finite, > 0", fmt::format("{} {:g} at t = {:g}", name, value, row.at("time")), false};
  return {"finite, > 0", "yes", true};
}

/// Distance of the foremost shock from where the exact solution has it, in support radii of the gas ahead: a shock is
/// as wide. It is where the density, from the right, first passes the mean of both sides.
double front_distance(const fs::path& folder) {
  const Problem problem = resolve_problem((folder / "scene.used.toml").string(), {});
  const ParticleSet gas = read_particles(folder / "snap_0001.hdf5").particles;
  const std::vector<double> rho =
      hdf5::File::open(folder / "snap_0001.hdf5").group("PartType0").dataset("Densities").read<double>();
  const PlotHint hint = problem.scene->plot_hint(problem.settings);
  const auto exact = problem.scene->exact(problem.settings);
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

/// Largest difference of two snapshots, over the largest number of the same column.
double difference(const fs::path& one, const fs::path& other) {
  const hdf5::File a = hdf5::File::open(one), b = hdf5::File::open(other);
  const hdf5::Group gas_a = a.group("PartType0"), gas_b = b.group("PartType0");
  double largest = 0;
  for (const char* name : columns) {
    const auto x = gas_a.dataset(name).read<double>(), y = gas_b.dataset(name).read<double>();
    double scale = 0, off = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
      scale = std::max(scale, std::abs(x[i])), off = std::max(off, std::abs(x[i] - y[i]));
    if (off > 0) largest = std::max(largest, off / scale);
  }
  return largest;
}

/// Does a key say how the gas moves, and not where it starts or what is written?
bool is_of_engine(const std::string& key) {
  if (key == "time.end" || key == "time.max_steps") return false;
  return !key.starts_with("scene.") && !key.starts_with("ic.") && !key.starts_with("output.");
}

/// Some steps on from the last snapshot, with one thread and with two.
Outcome check_threads(const fs::path& folder) {
  const Problem problem = resolve_problem((folder / "scene.used.toml").string(), {});
  const fs::path start = folder / "snap_0001.hdf5";
  const double time = read_particles(start).particles.time;
  std::vector<fs::path> ends;
  for (const char* threads : {"1", "2"}) {
    const fs::path out = folder / (std::string("threads_") + threads);
    std::vector<std::string> words{
        start.string(), "--out", out.string(), "--steps", "3", "--t-end", fmt::format("{}", 2 * time),
        "--threads",    threads, "--overwrite"};
    for (const Key& key : problem.settings.keys())
      if (is_of_engine(key.name)) {
        const auto* text = std::get_if<std::string>(&key.value);
        words.insert(words.end(), {"--set", key.name + "=" + (text ? *text : to_text(key.value))});
      }
    const fs::path log = out.string() + ".log";
    if (const int code = run_child(words, log); code != ExitCode::done)
      return {"1, 2 threads agree", reason_of(code, log), false};
    ends.push_back(out / "snap_0001.hdf5");
  }
  const double off = difference(ends[0], ends[1]);
  return {"1, 2 threads < 1e-12", fmt::format("{:.2g}", off), off < 1e-12};
}

double quantity_of(const std::string& name, const fs::path& folder, const Json& run) {
  if (name == "front") return front_distance(folder);
  if (name == "energy" || name == "momentum" || name == "angular_momentum") return run["conservation"][name];
  if (name == "pairs") {  // of an update, over the neighbour number
    const double pairs = run["pair_interactions"], updates = run["updates"], neighbours = run["neighbours"];
    return pairs / (updates * neighbours);
  }
  if (name.starts_with("l1_")) return run["errors"][name.substr(3)]["l1"];
  return read_history(folder / "history.csv").back().at(name);
}

std::string to_text(const Requirement& requirement) {
  if (std::isfinite(requirement.below)) return fmt::format("{} < {:g}", requirement.quantity, requirement.below);
  if (std::isfinite(requirement.above)) return fmt::format("{} > {:g}", requirement.quantity, requirement.above);
  return requirement.quantity + " recorded";
}

}  // namespace

std::vector<Outcome> outcomes_of(const ExtremeCase& one, const fs::path& folder) {
  std::vector<Outcome> outcomes{check_numbers(folder), check_threads(folder)};
  const Json run = read_json(folder / "run.json");
  for (const Requirement& requirement : one.requirements) {
    const double value = quantity_of(requirement.quantity, folder, run);
    outcomes.push_back(
        {to_text(requirement), fmt::format("{:.2g}", value), value < requirement.below && value > requirement.above});
  }
  return outcomes;
}

}  // namespace sphk
