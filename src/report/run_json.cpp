#include "src/report/run_json.hpp"

#include <nlohmann/json.hpp>

#include "src/report/machine.hpp"

namespace sphk {

namespace {

using Json = nlohmann::ordered_json;

Json phases(const Costs& costs) {
  Json json = Json::object();
  for (const auto& [name, seconds] : costs.phases) json[name] = seconds;
  return json;
}

Json conservation(const Conservation& c) {
  return {{"energy", c.energy}, {"momentum", c.momentum}, {"angular_momentum", c.angular_momentum}, {"mass", c.mass}};
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
    json[measure] = {{"l1", deviation.l1()}, {"at", at}};
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
          {"nearest", {{"mean", b.nearest}, {"percentile_5", b.nearest_low}}}};
}

}  // namespace

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
      {"peak_memory_bytes", peak_memory_bytes()},
      {"bytes_per_particle", r.costs.bytes_per_particle},
      {"flops_per_second", r.flops_per_second()},
      {"fma_peak", r.platform.fma_peak},
      {"share_of_peak", r.share_of_peak()},
      {"conservation", conservation(r.conservation)},
      {"errors", errors(r.errors)},
      {"deviations", deviations(r.deviations)},
      {"left_out", r.left_out},
      {"warnings", r.warnings},
      {"version", r.build.version},
      {"git_revision", r.build.git_revision},
      {"compiler", r.build.compiler},
      {"machine", machine_name()},
  };
  if (r.budget) json["error_budget"] = error_budget(*r.budget);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace sphk
