#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/run/failure.hpp"
#include "src/run/run.hpp"

namespace sphk {

struct RunOptions {
  RunRequest request;
  bool dry_run = false, json_log = false;
};

/// Every command returns its exit code, or throws what current_failure() tells of. Those that are one call have no file
/// of their own.
int run_command(const RunOptions& options);
int list_command();
int show_command(const std::string& what, const std::vector<Override>& overrides);
/// Two studies, point by point: ratios of errors and CPU seconds, and what got worse. Files, or the folders of studies.
int study_compare_command(const std::filesystem::path& before, const std::filesystem::path& after,
                          const std::string& norm);
/// The papers' tables, computed, beside what they print; in `folder` as CSV files, with a figure of the kernels.
int tables_command(const std::optional<std::filesystem::path>& folder);
int ic_check_command(const std::string& file);

}  // namespace sphk
