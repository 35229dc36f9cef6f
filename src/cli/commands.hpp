#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/cli/problem.hpp"
#include "src/study/points.hpp"

namespace sphk {

/// Exit codes of sphk; scripts rely on them.
struct ExitCode {
  static constexpr int done = 0, bad_input = 2, numerics = 3, device = 4, stopped = 75;
};

struct RunOptions {
  std::string what;
  std::vector<Override> overrides;
  std::optional<std::filesystem::path> out;
  bool overwrite = false, dry_run = false, json_log = false;
  std::optional<std::filesystem::path> resume;  ///< the folder of a run to go on with; `what` is empty then
  double walltime = 0;                          ///< wall-clock seconds after which the run stops; 0: no limit
};

struct PlotOptions {
  std::vector<std::string> what;             ///< a run's folder or a snapshot; several: their maps side by side
  std::optional<std::filesystem::path> out;  ///< file of the only figure, or folder of several
  bool exact = true, every = false, conservation = false, errors = false;
  std::string profile;  ///< the field of several runs that is drawn a panel each; empty: none
};

struct RatesOptions {
  std::string file;
  std::vector<Override> overrides;
  std::filesystem::path out;
  bool split = false;
  std::string alpha = "auto";  ///< auto | file | a number
};

struct StabilityOptions {
  std::string kernel, lattice = "cubic";
  double neighbours = 0;  ///< or
  double h = 0;           ///< in spacings; 0: as the neighbour number has it
  double gamma = 5.0 / 3;
  std::optional<std::filesystem::path> out;  ///< folder of the maps
};

struct StudyOptions {
  std::vector<std::string> what;  ///< a scene, a study file or a preset; or the word compare and two studies
  std::vector<StudyAxis> axes;    ///< what differs from point to point
  std::vector<std::pair<std::string, std::string>> fixed;  ///< keys of all points
  /// The study file's own where these are empty or zero.
  std::string norm;
  double target = 0;
  std::vector<double> budgets;
  int repeat = 0;
  std::string others;
  double max_seconds = 0;  ///< start no further point after so many; 0: no limit
  int threads = 0;         ///< of each run; 0: what OpenMP gives
  std::optional<std::filesystem::path> out, report;
};

struct ExtremesOptions {
  std::optional<std::filesystem::path> out;
  std::vector<std::string> cases;  ///< names, or files (*.toml); without names: all
  int threads = 0;                 ///< of each run; 0: what OpenMP gives
};

struct GalleryOptions {
  std::optional<std::filesystem::path> out;
  std::vector<std::string> scenes;  ///< empty: all
  int threads = 0;                  ///< of each run; 0: what OpenMP gives
};

struct TablesOptions {
  std::optional<std::filesystem::path> out;  ///< folder of CSV files and the kernels' figure
};

/// Every command returns its exit code and throws InputError, NumericsError or DeviceError.
int run_command(const RunOptions& options);
/// What a run would cost: particles, memory, steps, size of the output, time from a trial of three steps.
int dry_run_command(const Problem& problem);
int list_command();
int show_command(const std::string& what, const std::vector<Override>& overrides);
int plot_command(const PlotOptions& options);
int info_command(const std::string& file);
int rates_command(const RatesOptions& options);
/// Linear waves of a kernel and neighbour number on a lattice (R10 sec 3).
int stability_command(const StabilityOptions& options);
/// Error against run time over every combination of schemes, kernels, resolutions, ...
int study_command(const StudyOptions& options);
/// A small run of every scene, and one page with them all.
int gallery_command(const GalleryOptions& options);
/// Stiff and extreme runs, and whether they keep within their bounds.
int extremes_command(const ExtremesOptions& options);
/// Two studies, point by point: ratios of errors and CPU seconds, and what got worse. Files, or the folders of studies.
int study_compare_command(const std::filesystem::path& before, const std::filesystem::path& after,
                          const std::string& norm);
/// The papers' tables, computed, beside what they print.
int tables_command(const TablesOptions& options);
int ic_check_command(const std::string& file);

}  // namespace sphk
