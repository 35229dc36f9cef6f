#include "src/study/study_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "src/report/html.hpp"

namespace sphk {

namespace {

using Json = nlohmann::ordered_json;

std::string machines_of(const std::vector<OtherPoint>& others) {
  std::set<std::string> machines;
  for (const OtherPoint& other : others) machines.insert(other.machine);
  return fmt::format("{}", fmt::join(machines, "; "));
}

std::string meaning_of(const StudyPlan& plan) {
  const bool field = is_field_error(plan.norm);
  return fmt::format(
      "<p>L1({}) is {}. CPU seconds are of all threads in the time loop, without set-up and output{}; every run is a "
      "process of its own, after a trial of three steps that warms the machine up. A star marks runs that no other "
      "beats both in error and in CPU time. Times to an error are interpolated between runs in logarithms.</p>\n",
      html_text(plan.norm),
      field
          ? "the mean over bins of the distance between the particles' mean in a bin and the exact solution at its "
            "centre (Read &amp; Hayfield 2012, eq 44)"
          : "the distance from converged runs of other methods, summed over the times they are known at, over the sum "
            "of their values",
      plan.repeat > 1 ? fmt::format(", the least of {} runs", plan.repeat) : "");
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
  add("Runs by rising cost", study_table(results, plan.norm),
      any_joules(results)
          ? ""
          : "The energy that an update takes is left out: this machine does not let it be read (RAPL).");
  Table failures{{"failed run", "n", "after s", "why"}, {}, {0, 3}};
  for (const StudyResult& r : results)
    if (!r.valid())
      failures.rows.push_back({r.point.method(), fmt::format("{:g}", r.n), fmt::format("{:.3g}", r.wall),
                               r.failure.substr(0, r.failure.find('\n'))});
  add("Failures", failures);
  add("Convergence", order_table(results));
  return answers;
}

std::string report_page(const StudyPlan& plan, const StudyAnswers& answers, const StudyRecord& record,
                        const std::filesystem::path& figure) {
  const auto text = [&](const char* key) { return html_text(record.json[key].get<std::string>()); };
  const std::string title = fmt::format("Error against run time: {}", plan.name.empty() ? plan.scene : plan.name);
  std::string body = fmt::format("<h1>{}</h1>\n", html_text(title));
  if (!plan.summary.empty()) body += fmt::format("<p>{}</p>\n", html_text(plan.summary));
  body += fmt::format("<p class=\"meta\">{} &middot; sphk {} ({}) &middot; {}</p>\n", text("machine"), text("version"),
                      text("git_revision"), text("compiler"));
  if (std::filesystem::exists(figure))
    body += fmt::format(
        "<figure>{}<figcaption>Error against CPU seconds, resolution and pair interactions, and the drift "
        "of the energy.</figcaption></figure>\n",
        html_image(figure,
                   "Four panels: error against CPU seconds, against resolution, against pair "
                   "interactions, and the drift of the energy"));
  for (const StudyAnswers::Part& part : answers.parts) {
    body += fmt::format("<h2>{}</h2>\n<div class=\"wide\">{}</div>\n", html_text(part.title), part.table.html());
    if (!part.note.empty()) body += fmt::format("<p class=\"meta\">{}</p>\n", html_text(part.note));
  }
  body += "<h2>What the numbers mean</h2>\n" + meaning_of(plan);
  body += fmt::format("<h2>Keys of all runs</h2>\n<pre>sphk run {}{}</pre>\n", html_text(plan.scene),
                      html_text(keys_of(record.json["fixed"])));
  return html_page(title, body);
}

}  // namespace sphk
