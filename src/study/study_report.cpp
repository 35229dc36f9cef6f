// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/study_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "src/io/atomic_file.hpp"
#include "src/report/csv.hpp"
#include "src/report/plot_script.hpp"
#include "src/scenes/norms.hpp"

namespace sphk {

namespace {

using Json = nlohmann::ordered_json;

/// A method's points, as the drawing script takes them.
Json line_of(const StudyPlan& plan, const std::vector<StudyResult>& method, const std::vector<StudyResult>& all) {
  const auto order = plan.measured ? std::nullopt : fitted_order(method);
  Json points = Json::array();
  for (const StudyResult& r : method)
    points.push_back({{"n", r.n},
                      {"error", r.error},
                      {"cpu", r.cpu},
                      {"pairs", r.pairs},
                      {"drift", r.energy_drift},
                      {"front", !plan.measured && on_front(r, all)}});
  return {{"method", method[0].point.method()}, {"order", order ? Json(*order) : Json(nullptr)}, {"points", points}};
}

std::string machines_of(const std::vector<OtherPoint>& others) {
  std::set<std::string> machines;
  for (const OtherPoint& other : others) machines.insert(other.machine);
  return fmt::format("{}", fmt::join(machines, "; "));
}

std::string keys_of(const Json& fixed) {
  std::string text;
  for (const auto& [key, value] : fixed.items()) text += fmt::format(" --set {}={}", key, value.get<std::string>());
  return text;
}

}  // namespace

std::string StudyAnswers::text() const {
  std::string text;
  for (const Part& part : parts)
    text += fmt::format("{}\n{}{}\n", part.title, part.table.text(), part.note.empty() ? "" : "  " + part.note + "\n");
  return text;
}

StudyAnswers answers_of(const StudyPlan& plan, const std::vector<StudyResult>& results,
                        const std::vector<OtherPoint>& others) {
  StudyAnswers answers;
  const auto add = [&](const std::string& title, Table table, const std::string& note = "") {
    if (!table.rows.empty()) answers.parts.push_back({title, std::move(table), note});
  };
  if (plan.target > 0) add("Time to the target", target_table(results, plan.target));
  if (!plan.budgets.empty()) add("Best choice for a time", budget_table(results, plan.budgets));
  if (!others.empty())
    add("To reach what others reach", others_table(results, others),
        fmt::format("Their time was measured on another machine: {}.", machines_of(others)));
  add("Runs by rising cost", study_table(results, plan.quantity(), !plan.measured),
      any_joules(results)
          ? ""
          : "The energy that an update takes is left out: this machine does not let it be read (RAPL).");
  Table failures{{"failed run", "n", "after s", "why"}, {}, {0, 3}};
  for (const StudyResult& r : results)
    if (!r.valid())
      failures.rows.push_back({r.point.method(), fmt::format("{:g}", r.n), fmt::format("{:.3g}", r.wall),
                               r.failure.substr(0, r.failure.find('\n'))});
  add("Failures", failures);
  if (!plan.measured) add("Convergence", order_table(results));
  add("Speed", cost_table(results));
  return answers;
}

std::vector<std::string> names_on_front(const std::vector<StudyResult>& results) {
  std::vector<std::string> names;
  for (const StudyResult& r : results)
    if (on_front(r, results)) names.push_back(r.point.name());
  return names;
}

void write_table(const std::filesystem::path& path, const std::vector<StudyResult>& results) {
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

void draw_study(const std::filesystem::path& path, const StudyPlan& plan, const std::string& machine,
                const std::vector<StudyResult>& results, const std::vector<OtherPoint>& others) {
  Json lines = Json::array();
  for (const auto& group : by_method(results)) lines.push_back(line_of(plan, group, results));
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
      {"quantity", plan.measured                         ? plan.norm
                   : meaning_of_error(plan.norm).empty() ? "$L_1$ deviation of " + plan.norm
                                                         : "$L_1$ error of " + plan.norm},
      {"title", fmt::format("{} on {}", plan.scene, machine)},
      {"target", plan.target},
      {"out",
       path.string()}}.dump());
}

void draw_speed(const std::filesystem::path& path, const StudyPlan& plan, const std::string& machine,
                const std::vector<StudyResult>& results) {
  Json bars = Json::array();
  for (const CostRatio& r : cost_ratios(results))
    bars.push_back({{"method", r.method}, {"n", r.n}, {"update", r.update}, {"run", r.run}});
  if (bars.empty()) return;
  run_plot_script(Json{
      {"speed", bars},
      {"title", fmt::format("{}, n = {:g}, on {}", plan.scene, bars[0]["n"].get<double>(), machine)},
      {"out",
       path.string()}}.dump());
}

void write_report(const std::filesystem::path& path, const StudyPlan& plan, const StudyAnswers& answers,
                  const StudyRecord& record, const std::vector<StudyFigure>& figures) {
  Json shown = Json::array(), parts = Json::array();
  for (const auto& [file, caption] : figures)
    if (std::filesystem::exists(file)) shown.push_back({{"file", file.string()}, {"caption", caption}});
  for (const StudyAnswers::Part& part : answers.parts)
    parts.push_back({{"title", part.title},
                     {"head", part.table.head},
                     {"rows", part.table.rows},
                     {"words", part.table.words},
                     {"note", part.note}});
  Json work = {{"page", "study.html"},
               {"out", path.string()},
               {"title", fmt::format("Error against run time: {}", plan.name.empty() ? plan.scene : plan.name)},
               {"summary", plan.summary},
               {"figures", shown},
               {"parts", parts},
               {"norm", plan.norm},
               {"measured", plan.measured},
               {"mean_error", meaning_of_error(plan.norm)},
               {"repeat", plan.repeat},
               {"command", fmt::format("sphk run {}{}", plan.scene, keys_of(record.json["fixed"]))}};
  for (const char* key : {"machine", "version", "git_revision", "compiler"}) work[key] = record.json[key];
  run_plot_script(work.dump(), packages_of_pages);
}

}  // namespace sphk
