// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/run_json.hpp"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "src/engine/errors.hpp"
#include "src/report/machine.hpp"

namespace sphk {

namespace {

using Json = nlohmann::ordered_json;

Json phases(const Costs& costs) {
  Json json = Json::object();
  for (const auto& [name, seconds] : costs.phases) json[name] = seconds;
  return json;
}

Json counts(const Counts& c) {
  return {{"bisections", c.bisections},
          {"capped", c.capped},
          {"crowded", c.crowded},
          {"failed", c.failed},
          {"linear_fits", c.linear_fits},
          {"sph_estimates", c.sph_estimates},
          {"softened_heat", c.softened_heat},
          {"softened_mass", c.softened_mass}};
}

Json conservation(const Conservation& c) {
  const auto number = [](const std::optional<double>& x) { return x ? Json(*x) : Json(nullptr); };
  return {{"energy", c.energy},
          {"momentum", c.momentum},
          {"angular_momentum", c.angular_momentum},
          {"mass", c.mass},
          {"momentum_of_start", number(c.momentum_of_start)},
          {"angular_momentum_of_start", number(c.angular_momentum_of_start)}};
}

Json errors(const std::map<std::string, ErrorNorm>& norms) {
  Json json = Json::object();
  for (const auto& [field, norm] : norms)
    json[field] = {{"l1", norm.l1}, {"l2", norm.l2}, {"linf", norm.linf}, {"where", norm.where}};
  return json;
}

Json deviations(const std::map<std::string, Deviation>& deviations) {
  Json json = Json::object();
  for (const auto& [measure, deviation] : deviations) {
    Json at = Json::array();
    for (const Deviation::At& a : deviation.at)
      at.push_back({{"time", a.time}, {"value", a.value}, {"low", a.low}, {"high", a.high}});
    json[measure] = {{"l1", deviation.l1()}, {"over_start", deviation.over_start}, {"at", at}};
  }
  return json;
}

Json share(const ErrorShare& s) {
  return {{"particles", s.particles}, {"mean", s.mean}, {"percentile_95", s.high}, {"max", s.max}};
}

Json error_budget(const ErrorBudget& b) {
  return {{"E0", {{"all", share(b.all)}, {"boundary", share(b.boundary)}, {"bulk", share(b.bulk)}}},
          {"R", b.R},
          {"V", b.V},
          {"epsilon", b.epsilon},
          {"nearest", {{"mean", b.nearest}, {"percentile_5", b.nearest_low}}}};
}

/// A number, or NaN where it is null.
double number(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

ErrorShare read_share(const Json& json) {
  return {json.at("particles"), number(json.at("mean")), number(json.at("percentile_95")), number(json.at("max"))};
}

ErrorBudget read_budget(const Json& json) {
  const Json &e0 = json.at("E0"), &nearest = json.at("nearest");
  return {.all = read_share(e0.at("all")),
          .boundary = read_share(e0.at("boundary")),
          .bulk = read_share(e0.at("bulk")),
          .R = number(json.at("R")),
          .V = number(json.at("V")),
          .epsilon = json.contains("epsilon") ? number(json.at("epsilon")) : 0,
          .nearest = number(nearest.at("mean")),
          .nearest_low = number(nearest.at("percentile_5"))};
}

void read_results(const Json& json, RunRecord& r) {
  const Json& c = json.at("conservation");
  r.conservation.energy = number(c.at("energy"));
  r.conservation.momentum = number(c.at("momentum"));
  r.conservation.angular_momentum = number(c.at("angular_momentum"));
  r.conservation.mass = number(c.at("mass"));
  for (const auto& [field, norm] : json.at("errors").items()) {
    ErrorNorm& error = r.errors[field];
    error = {number(norm.at("l1")), number(norm.at("l2")), number(norm.at("linf")), {}};
    for (std::size_t k = 0; k < 3; ++k) error.where[k] = number(norm.at("where").at(k));
  }
  for (const auto& [measure, deviation] : json.at("deviations").items()) {
    Deviation& found = r.deviations[measure];
    found.over_start = deviation.value("over_start", false);
    for (const Json& at : deviation.at("at"))
      found.at.push_back({number(at.at("time")), number(at.at("value")), number(at.at("low")), number(at.at("high"))});
  }
  if (json.contains("error_budget")) r.budget = read_budget(json.at("error_budget"));
}

void read_costs(const Json& json, RunRecord& r) {
  r.steps = json.at("steps");
  r.wall_seconds = number(json.at("wall_seconds"));
  r.cpu_seconds = number(json.at("cpu_seconds"));
  if (!json.at("joules").is_null()) r.joules = json.at("joules").get<double>();
  r.setup_seconds = number(json.at("setup_seconds"));
  r.output_seconds = number(json.at("output_seconds"));
  r.peak_memory_bytes = number(json.at("peak_memory_bytes"));
  r.platform.fma_peak = number(json.at("fma_peak"));
  r.costs.updates = json.at("updates");
  r.costs.pair_interactions = number(json.at("pair_interactions"));
  r.costs.flops = number(json.at("flops_per_second")) * r.wall_seconds;
  r.costs.bytes_per_particle = number(json.at("bytes_per_particle"));
  for (const auto& [name, seconds] : json.at("seconds_by_phase").items())
    r.costs.phases.emplace_back(name, number(seconds));
}

}  // namespace

RunRecord read_run_json(const std::string& text, const std::string& name) {
  try {
    const Json json = Json::parse(text);
    RunRecord r;
    r.scene = json.at("scene");
    r.scheme = json.at("scheme");
    r.kernel = json.at("kernel");
    r.neighbours = number(json.at("neighbours"));
    r.particles = json.at("particles");
    r.dimension = json.at("dimension");
    r.time = number(json.at("time"));
    r.finished = json.at("finished");
    json.at("warnings").get_to(r.warnings);
    read_costs(json, r);
    read_results(json, r);
    return r;
  } catch (const Json::exception& error) {
    throw InputError(
        fmt::format("{} cannot be read ({}); sphk leaves a whole one when a run ends or stops", name, error.what()));
  }
}

std::string run_json(const RunRecord& r) {
  Json json = {
      {"scene", r.scene},
      {"scheme", r.scheme},
      {"kernel", r.kernel},
      {"neighbours", r.neighbours},
      {"n", r.n},
      {"particles", r.particles},
      {"dimension", r.dimension},
      {"precision", r.platform.precision},
      {"backend", r.platform.backend},
      {"device", r.platform.device},
      {"threads", r.platform.threads},
      {"finished", r.finished},
      {"time", r.time},
      {"steps", r.steps},
      {"updates", r.costs.updates},
      {"pair_interactions", r.costs.pair_interactions},
      {"wall_seconds", r.wall_seconds},
      {"cpu_seconds", r.cpu_seconds},
      {"joules", r.joules ? Json(*r.joules) : Json(nullptr)},
      {"setup_seconds", r.setup_seconds},
      {"output_seconds", r.output_seconds},
      {"seconds_by_phase", phases(r.costs)},
      {"updates_per_second", r.updates_per_second()},
      {"pairs_per_second", r.pairs_per_second()},
      {"peak_memory_bytes", r.peak_memory_bytes},
      {"bytes_per_particle", r.costs.bytes_per_particle},
      {"flops_per_second", r.flops_per_second()},
      {"fma_peak", r.platform.fma_peak},
      {"share_of_peak", r.share_of_peak()},
      {"counts", counts(r.counts)},
      {"conservation", conservation(r.conservation)},
      {"errors", errors(r.errors)},
      {"deviations", deviations(r.deviations)},
      {"left_out", r.left_out},
      {"warnings", r.warnings},
      {"version", r.build.version},
      {"git_revision", r.build.git_revision},
      {"compiler", r.build.compiler},
      {"compiler_flags", r.build.flags},
      {"kokkos", r.build.kokkos},
      {"command", r.provenance.command},
      {"host", r.provenance.host},
      {"date", r.provenance.date},
      {"machine", machine_name()},
  };
  if (r.budget) json["error_budget"] = error_budget(*r.budget);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace sphk
