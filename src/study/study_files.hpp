#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/study/plan.hpp"
#include "src/study/results.hpp"

namespace sphk {

/// Names of the points that no other beats both in error and in CPU seconds.
std::vector<std::string> names_on_front(const std::vector<StudyResult>& results);

/// study.csv: a line a point.
void write_table(const std::filesystem::path& path, const std::vector<StudyResult>& results);

/// study.png; nothing where no run came to its end.
void draw_study(const std::filesystem::path& path, const StudyPlan& plan, const std::string& machine,
                const std::vector<StudyResult>& results, const std::vector<OtherPoint>& others);

}  // namespace sphk
