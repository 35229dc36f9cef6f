// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/study/points.hpp"

namespace sphk {

/// What a study asks of its points. Where a file and the command line both say, the command line has its way.
struct StudyQuestions {
  std::string norm;   ///< whose L1 error counts, or StudyPlan::measured; empty: v, or the first measure with references
  double target = 0;  ///< an error to reach; 0: none
  std::vector<double> budgets;   ///< CPU seconds: which method does best with them?
  int repeat = 0;                ///< runs of each point; 0: one
  std::filesystem::path others;  ///< file with points of other engines; empty: none
  KeyTexts fixed;                ///< keys of all points
};

/// What a study runs and asks.
struct StudyPlan : StudyQuestions {
  std::string name;     ///< of its file; empty: it comes from the command line
  std::string summary;  ///< one line
  std::string scene;
  std::vector<StudyPoint> points;
  /// The norm is a column of history.csv as it is at the end, which is not known to be an error: nothing says what it
  /// should be.
  bool measured = false;

  /// What the norm is, for a table's head: "L1(v)", "mixA at the end".
  std::string quantity() const { return measured ? norm + " at the end" : "L1(" + norm + ")"; }
};

/// Is this a study file: TOML with a list of methods or a table of what to vary?
bool is_study_file(const std::filesystem::path& path);

/// Reads a study file: `scene`, and all others optional: `summary`, `norm`, `target`, `budgets`, `repeat`, `others` (a
/// file beside this one), [set] with keys of all runs, [vary] with lists of values, and [[methods]], each with keys of
/// its own. Keys are written as in a scene file; every method runs with every combination of [vary], but for keys that
/// it sets itself, and a list in a method is varied as well. Throws InputError with line and caret.
StudyPlan read_study_file(const std::filesystem::path& path);

/// Study files of a folder, by name; none where there is no such folder.
std::vector<StudyPlan> study_files_in(const std::filesystem::path& folder);

}  // namespace sphk
