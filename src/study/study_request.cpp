#include "src/study/study_request.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/engine/errors.hpp"
#include "src/report/process.hpp"
#include "src/run/problem.hpp"
#include "src/study/others.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

/// A preset's file, a study file, or the axes of the command line; with the request's own choices.
StudyPlan asked_plan(const StudyRequest& request) {
  const std::string& what = request.what;
  const fs::path preset = shared_folder() / "studies" / (what + ".toml");
  const bool named = what.find('/') == std::string::npos && fs::exists(preset);
  StudyPlan plan;
  if (named || is_study_file(what)) {
    plan = read_study_file(named ? preset : fs::path(what));
    if (!request.axes.empty())
      throw InputError(fmt::format("{} says itself what it runs; name its scene, {}, to choose on the command line",
                                   what, plan.scene));
  } else {
    plan.scene = what;
    plan.points = product_of(request.axes);
  }
  for (const auto& key : request.fixed) {
    std::erase_if(plan.fixed, [&](const auto& other) { return other.first == key.first; });
    plan.fixed.push_back(key);
  }
  if (!request.norm.empty()) plan.norm = request.norm;
  if (request.target > 0) plan.target = request.target;
  if (!request.budgets.empty()) plan.budgets = request.budgets;
  if (request.repeat > 0) plan.repeat = request.repeat;
  if (!request.others.empty()) plan.others = request.others;
  return plan;
}

/// Throws InputError where a point's keys are none or nothing measures its error, before anything runs. Chooses the
/// norm where nobody did.
void check(StudyPlan& plan) {
  for (const StudyPoint& point : plan.points) {
    std::vector<Override> keys;
    for (const auto* list : {&std::as_const(plan.fixed), &point.keys})
      for (const auto& [key, value] : *list) keys.push_back({key, value, key + "=" + value});
    const Problem problem = resolve_problem(plan.scene, keys);
    if (problem.scene->exact(problem.settings)) {
      if (plan.norm.empty()) plan.norm = std::string("v");
      continue;
    }
    const std::vector<Reference> references = problem.scene->references(problem.settings);
    if (const std::string wanted = problem.scene->keys_with_references(); references.empty())
      throw InputError(fmt::format(
          "{} has neither an exact solution nor values of converged runs{}", plan.scene,
          wanted.empty() ? ", so there is no error to study" : " with these keys; it has them with --set " + wanted));
    if (plan.norm.empty()) plan.norm = references[0].measure;
    if (std::ranges::find(references, plan.norm, &Reference::measure) == references.end())
      throw InputError(fmt::format("{} has no converged values of \"{}\"; take --norm {}", plan.scene, plan.norm,
                                   references[0].measure));
  }
}

}  // namespace

StudyPlan plan_of(const StudyRequest& request) {
  StudyPlan plan = asked_plan(request);
  check(plan);
  if (!plan.others.empty()) read_others(plan.others);
  return plan;
}

}  // namespace sphk
