#include "src/run/rates.hpp"

#include <fmt/format.h>

#include "src/cli/commands.hpp"

namespace sphk {

int rates_command(const RatesRequest& request) {
  const RatesResult result = rates(request);
  for (const std::string& warning : result.warnings) fmt::print("note: {}\n", warning);
  fmt::print("{}: {} fields of {} particles\n", request.out.string(), result.fields, result.particles);
  return ExitCode::done;
}

}  // namespace sphk
