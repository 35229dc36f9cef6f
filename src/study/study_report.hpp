// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/study/study_record.hpp"

namespace sphk {

/// What a study found, for the terminal and for the page.
struct StudyAnswers {
  struct Part {
    std::string title;
    Table table;
    std::string note;  ///< below the table; may be empty
  };
  std::vector<Part> parts;
  std::string text() const;
};

StudyAnswers answers_of(const StudyPlan& plan, const std::vector<StudyResult>& results,
                        const std::vector<OtherPoint>& others);

/// Names of the points that no other beats both in error and in CPU seconds.
std::vector<std::string> names_on_front(const std::vector<StudyResult>& results);

/// study.csv: a line a point.
void write_table(const std::filesystem::path& path, const std::vector<StudyResult>& results);

/// study.png; nothing where no run came to its end.
void draw_study(const std::filesystem::path& path, const StudyPlan& plan, const std::string& machine,
                const std::vector<StudyResult>& results, const std::vector<OtherPoint>& others);

/// speed.png: what an update costs, beside the first method; nothing below two methods.
void draw_speed(const std::filesystem::path& path, const StudyPlan& plan, const std::string& machine,
                const std::vector<StudyResult>& results);

/// A picture of the page and what it shows.
struct StudyFigure {
  std::filesystem::path file;
  std::string caption;
};

/// One self-contained HTML page with everything about a study; figures that are not there are left out. Prints its
/// name.
void write_report(const std::filesystem::path& path, const StudyPlan& plan, const StudyAnswers& answers,
                  const StudyRecord& record, const std::vector<StudyFigure>& figures);

}  // namespace sphk
