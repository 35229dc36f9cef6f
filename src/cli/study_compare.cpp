#include "src/study/study_compare.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/cli/commands.hpp"

namespace sphk {

int study_compare_command(const std::filesystem::path& before, const std::filesystem::path& after,
                          const std::string& norm) {
  const StudyComparison comparison = compare_studies(before, after, norm);
  fmt::print("before: {}\nafter:  {}\n\n", comparison.before, comparison.after);
  fmt::print("  {:<40} {:>6} {:>12} {:>12}\n", "method", "n", "error ratio", "CPU ratio");
  for (const ComparedPoint& point : comparison.points)
    fmt::print("  {:<40} {:>6} {:>12.3f} {:>12.3f}  {}\n", point.method, point.n, point.error, point.cpu,
               point.verdict);
  fmt::print("\n{} points compared, {} of them worse: an error larger by 2 %, or 15 % more CPU time\n",
             comparison.points.size(), std::ranges::count_if(comparison.points, [](const ComparedPoint& point) {
               return !point.verdict.empty();
             }));
  return ExitCode::done;
}

}  // namespace sphk
