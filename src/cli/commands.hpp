#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/run/failure.hpp"
#include "src/run/plot.hpp"
#include "src/run/rates.hpp"
#include "src/run/run.hpp"
#include "src/study/extreme_table.hpp"
#include "src/study/gallery.hpp"
#include "src/study/study_request.hpp"

namespace sphk {

struct RunOptions {
  RunRequest request;
  bool dry_run = false, json_log = false;
};

struct StabilityOptions {
  std::string kernel, lattice = "cubic";
  double neighbours = 0;  ///< or
  double h = 0;           ///< in spacings; 0: as the neighbour number has it
  double gamma = 5.0 / 3;
  std::optional<std::filesystem::path> out;  ///< folder of the maps
};

struct TablesOptions {
  std::optional<std::filesystem::path> out;  ///< folder of CSV files and the kernels' figure
};

/// Every command returns its exit code, or throws what current_failure() tells of.
int run_command(const RunOptions& options);
int list_command();
int show_command(const std::string& what, const std::vector<Override>& overrides);
int plot_command(const PlotRequest& request);
int info_command(const std::string& file);
int rates_command(const RatesRequest& request);
/// Linear waves of a kernel and neighbour number on a lattice (R10 sec 3).
int stability_command(const StabilityOptions& options);
int study_command(const StudyRequest& request);
int gallery_command(const GalleryRequest& request);
/// Stiff and extreme runs, and whether they keep within their bounds.
int extremes_command(const ExtremesRequest& request);
/// Two studies, point by point: ratios of errors and CPU seconds, and what got worse. Files, or the folders of studies.
int study_compare_command(const std::filesystem::path& before, const std::filesystem::path& after,
                          const std::string& norm);
/// The papers' tables, computed, beside what they print.
int tables_command(const TablesOptions& options);
int ic_check_command(const std::string& file);

}  // namespace sphk
