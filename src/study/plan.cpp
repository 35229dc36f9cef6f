// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/engine/errors.hpp"
#include "src/run/toml_file.hpp"
#include "src/study/toml_values.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

constexpr double max_points = 10000, max_repeat = 1000;

int repeat_of(const toml::value& value) {
  const double number = positive_number_of(value);
  if (number != std::floor(number) || number > max_repeat)
    refuse(value, "not a number of runs", fmt::format("a whole number from 1 to {} is wanted here", max_repeat));
  return static_cast<int>(number);
}

/// One axis a key: a list's values, or the only one.
std::vector<StudyAxis> axes_of(const toml::value& table) {
  std::vector<StudyAxis> axes;
  for (const auto& [key, value] : keys_of(table)) {
    axes.push_back({key, {}});
    if (!value.is_array()) {
      axes.back().values.push_back(text_of(value));
      continue;
    }
    for (const toml::value& one : value.as_array()) axes.back().values.push_back(text_of(one));
    if (axes.back().values.empty()) refuse(value, "an empty list", "give at least one value");
  }
  return axes;
}

/// Every combination of the axes, which `where` gives; refuses more than anyone would run, before they fill the memory.
std::vector<StudyPoint> checked_product(const std::vector<StudyAxis>& axes, const toml::value& where) {
  double count = 1;
  for (const StudyAxis& axis : axes) count *= static_cast<double>(axis.values.size());
  if (count > max_points)
    refuse(where, fmt::format("{:.6g} combinations of values", count),
           fmt::format("at most {} are run; vary fewer keys, or give shorter lists", max_points));
  return product_of(axes);
}

std::vector<StudyPoint> points_of(const toml::value& file) {
  const std::vector<StudyAxis> vary = file.contains("vary") ? axes_of(file.at("vary")) : std::vector<StudyAxis>{};
  if (!file.contains("methods")) return vary.empty() ? product_of(vary) : checked_product(vary, file.at("vary"));
  if (!file.at("methods").is_array())
    refuse(file.at("methods"), "not a list of methods", "write [[methods]], with two brackets, above each");
  std::vector<StudyPoint> points;
  for (const toml::value& method : file.at("methods").as_array()) {
    std::vector<StudyAxis> axes = axes_of(method);
    const auto own = axes;
    std::ranges::copy_if(vary, std::back_inserter(axes), [&](const StudyAxis& axis) {
      return std::ranges::find(own, axis.key, &StudyAxis::key) == own.end();
    });
    std::ranges::move(checked_product(axes, method), std::back_inserter(points));
  }
  return points;
}

}  // namespace

bool is_study_file(const fs::path& path) {
  if (path.extension() != ".toml" || !fs::is_regular_file(path)) return false;
  const toml::value file = parse_toml(path, "study file");
  return file.contains("vary") || file.contains("methods");
}

StudyPlan read_study_file(const fs::path& path) {
  const toml::value file = parse_toml(path, "study file");
  StudyPlan plan;
  plan.name = path.stem().string();
  for (const auto& [name, value] : file.as_table()) {
    if (name == "scene")
      plan.scene = string_of(value);
    else if (name == "summary")
      plan.summary = string_of(value);
    else if (name == "norm")
      plan.norm = string_of(value);
    else if (name == "target")
      plan.target = positive_number_of(value);
    else if (name == "repeat")
      plan.repeat = repeat_of(value);
    else if (name == "others")
      plan.others = path.parent_path() / string_of(value);
    else if (name == "budgets" && value.is_array())
      std::ranges::transform(value.as_array(), std::back_inserter(plan.budgets), positive_number_of);
    else if (name == "set")
      for (const auto& [key, one] : keys_of(value)) plan.fixed.emplace_back(key, text_of(one));
    else if (name != "vary" && name != "methods")
      refuse(value, fmt::format("a study file has no \"{}\"", name),
             "it has scene, summary, norm, target, budgets (a list), repeat, others, [set], [vary] and [[methods]]");
  }
  if (plan.scene.empty())
    throw InputError(fmt::format("{} names no scene: begin it with a line such as scene = \"sod\"", path.string()));
  plan.points = points_of(file);
  return plan;
}

std::vector<StudyPlan> study_files_in(const fs::path& folder) {
  std::vector<StudyPlan> plans;
  if (fs::is_directory(folder))
    std::ranges::transform(toml_files_in(folder), std::back_inserter(plans), read_study_file);
  return plans;
}

}  // namespace sphk
