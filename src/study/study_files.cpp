#include "src/study/study_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "src/io/atomic_file.hpp"
#include "src/report/csv.hpp"
#include "src/report/plot_script.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

/// A method's points, as the drawing script takes them.
Json line_of(const std::vector<StudyResult>& method, const std::vector<StudyResult>& all) {
  const auto order = fitted_order(method);
  Json points = Json::array();
  for (const StudyResult& r : method)
    points.push_back({{"n", r.n},
                      {"error", r.error},
                      {"cpu", r.cpu},
                      {"pairs", r.pairs},
                      {"drift", r.energy_drift},
                      {"front", on_front(r, all)}});
  return {{"method", method[0].point.method()}, {"order", order ? Json(*order) : Json(nullptr)}, {"points", points}};
}

}  // namespace

std::vector<std::string> names_on_front(const std::vector<StudyResult>& results) {
  std::vector<std::string> names;
  for (const StudyResult& r : results)
    if (on_front(r, results)) names.push_back(r.point.name());
  return names;
}

void write_table(const fs::path& path, const std::vector<StudyResult>& results) {
  std::string csv = csv_line({"method", "n", "particles", "error", "energy_drift", "steps", "wall_seconds",
                              "cpu_seconds", "updates", "pairs", "memory", "joules", "failure"});
  const auto text = [](double value) { return fmt::format("{}", value); };
  for (const StudyResult& r : results)
    csv += csv_line({r.point.method(), text(r.n), text(r.particles), fmt::format("{:.9g}", r.error),
                     fmt::format("{:.3g}", r.energy_drift), text(r.steps), fmt::format("{:.6g}", r.wall),
                     fmt::format("{:.6g}", r.cpu), text(r.updates), text(r.pairs), text(r.bytes),
                     r.joules ? fmt::format("{:.6g}", *r.joules) : "", r.failure});
  write_atomically(path, csv);
}

void draw_study(const fs::path& path, const StudyPlan& plan, const std::string& machine,
                const std::vector<StudyResult>& results, const std::vector<OtherPoint>& others) {
  Json lines = Json::array();
  for (const auto& group : by_method(results)) lines.push_back(line_of(group, results));
  if (lines.empty()) return;
  Json failures = Json::array(), elsewhere = Json::array();
  for (const StudyResult& r : results)
    if (!r.valid()) failures.push_back({{"method", r.point.method()}, {"n", r.n}, {"cpu", r.cpu}});
  for (const OtherPoint& o : others)
    elsewhere.push_back(
        {{"engine", o.engine}, {"setting", o.setting}, {"error", o.error}, {"cpu", o.cpu}, {"machine", o.machine}});
  run_plot_script(Json{
      {"study", lines},
      {"failures", failures},
      {"others", elsewhere},
      {"norm", plan.norm},
      {"relative", !is_field_error(plan.norm)},
      {"title", fmt::format("{} on {}", plan.scene, machine)},
      {"target", plan.target},
      {"out",
       path.string()}}.dump());
}

}  // namespace sphk
