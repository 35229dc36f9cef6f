#include "src/io/info.hpp"

#include <fmt/format.h>

#include "src/cli/commands.hpp"

namespace sphk {

int info_command(const std::string& file) {
  fmt::print("{}\n", file_info(file));
  return ExitCode::done;
}

}  // namespace sphk
