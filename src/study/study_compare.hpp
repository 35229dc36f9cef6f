// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sphk {

/// A point of two studies.
struct ComparedPoint {
  std::string method, n;
  double error = 1, cpu = 1;  ///< ratios, after over before
  std::string verdict;        ///< what got worse: an error larger by 2 %, 15 % more CPU time, a failure; empty: nothing
};
struct StudyComparison {
  std::string before, after;  ///< file and machine of each
  std::vector<ComparedPoint> points;
};

/// Two studies, files or their folders, point by point, of those that both hold. `norm`: whose error counts; empty: the
/// first study's. Throws InputError where one is no study.
StudyComparison compare_studies(const std::filesystem::path& before, const std::filesystem::path& after,
                                const std::string& norm);

}  // namespace sphk
