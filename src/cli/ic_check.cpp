#include <fmt/format.h>

#include <algorithm>

#include "src/cli/commands.hpp"
#include "src/io/check.hpp"
#include "src/io/reader.hpp"

namespace sphk {

int ic_check_command(const std::string& file) {
  const ReadResult content = read_particles(file, NonFinite::keep);
  const auto findings = check_particles(content.particles);
  fmt::print("{}: {} gas particles in {}D\n", file, content.particles.size(), content.particles.dimension);
  for (const std::string& remark : content.remarks) fmt::print("  note: {}\n", remark);
  for (const Finding& finding : findings)
    fmt::print("  {}: {}\n", finding.severity == Finding::Severity::error ? "error" : "notice", to_text(finding));
  const bool sound =
      std::ranges::none_of(findings, [](const Finding& f) { return f.severity == Finding::Severity::error; });
  fmt::print("{}\n", sound ? "A run can start from it." : "No run can start from it: mend the errors above.");
  return sound ? ExitCode::done : ExitCode::bad_input;
}

}  // namespace sphk
