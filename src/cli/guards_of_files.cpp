#include <fmt/format.h>
#include <sys/resource.h>

#include "src/cli/commands.hpp"
#include "src/cli/guards.hpp"
#include "src/cli/plain_file.hpp"
#include "src/io/atomic_file.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

using Outcomes = std::vector<Outcome>;

/// Files may not grow beyond so many bytes, in this process and the runs that it starts.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(std::uintmax_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{.rlim_cur = bytes, .rlim_max = before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

/// A run of 8^3 particles that was stopped after its first step.
Command stopped_run(const std::string& folder, const std::string& dimension = "3") {
  return {{"run", "uniform", "-n", "8", "--set", "scene.lattice=cubic", "--set", "scene.dimension=" + dimension,
           "--set", "output.checkpoint=1e-9", "--walltime", "0.001", "--out", folder, "--overwrite"},
          ExitCode::stopped,
          {"sphk run --resume"}};
}

/// A limit of the size of files is met as a full disk is, by a write that fails.
Outcomes full_disk(const Workshop& shop) {
  const std::string run = shop.path("run"), other = shop.path("other");
  Outcomes outcomes{try_commands("exit 75 with a checkpoint", {stopped_run(run)}, shop)};
  if (!outcomes[0].passed) return outcomes;
  const auto snapshot = fs::file_size(shop.folder / "run" / "snap_0000.hdf5"),
             checkpoint = fs::file_size(shop.folder / "run" / "checkpoint_a.hdf5");
  {
    const FileSizeLimit limit(snapshot / 2);
    outcomes.push_back(
        try_commands("no room for a snapshot: exit 2",
                     {{{"run", "uniform", "-n", "8", "--set", "scene.lattice=cubic", "--out", other, "--overwrite"},
                       ExitCode::bad_input,
                       {other + "/snap_0000.hdf5", "cannot be written", "make room"}}},
                     shop));
  }
  {
    const FileSizeLimit limit((snapshot + checkpoint) / 2);
    outcomes.push_back(
        try_commands("nor for a checkpoint: exit 2",
                     {{{"run", "--resume", run},
                       ExitCode::bad_input,
                       {run + "/checkpoint_b.hdf5", "cannot be written", "make room", "sphk run --resume " + run}}},
                     shop));
  }
  outcomes.push_back(
      try_commands("room again: the older one goes on",
                   {{{"run", "--resume", run}, ExitCode::done, {"checkpoint_a.hdf5, step 1", "complete"}}}, shop));
  return outcomes;
}

Outcomes no_folder(const Workshop& shop) {
  write_plain_file(shop.path("gas.hdf5"), even_gas());
  write_atomically(shop.folder / "file", "in the way of a folder\n");
  std::vector<Command> commands;
  for (const std::string& place : {shop.path("file/run"), std::string("/proc/run")})
    commands.push_back({{"run", shop.path("gas.hdf5"), "--t-end", "0.1", "--steps", "1", "--out", place},
                        ExitCode::bad_input,
                        {"cannot make the run's folder", place, "choose another place with --out"}});
  commands.push_back({{"rates", shop.path("gas.hdf5"), "--out", shop.path("file/rates.hdf5")},
                      ExitCode::bad_input,
                      {shop.path("file/rates.hdf5"), "there is no folder", "mkdir"}});
  commands.push_back({{"rates", shop.path("gas.hdf5"), "--out", "/proc/rates.hdf5"},
                      ExitCode::bad_input,
                      {"/proc/rates.hdf5", "cannot be written", "choose another folder"}});
  return {try_commands("exit 2: folder, remedy", commands, shop)};
}

Outcomes wrong_files(const Workshop& shop) {
  write_plain_file(shop.path("whole.hdf5"), even_gas());
  const auto size = fs::file_size(shop.folder / "whole.hdf5");
  std::vector<Command> cut;
  for (const int quarters : {0, 1, 2, 3}) {
    const std::string name = fmt::format("cut-{}.hdf5", quarters);
    fs::copy_file(shop.folder / "whole.hdf5", shop.folder / name, fs::copy_options::overwrite_existing);
    fs::resize_file(shop.folder / name, quarters * size / 4);
    cut.push_back({{"run", shop.path(name), "--t-end", "0.1", "--out", shop.path("run"), "--overwrite"},
                   ExitCode::bad_input,
                   {name, "no readable HDF5 file", "anew"}});
  }
  const std::string run = shop.path("stopped"), flat = shop.path("stopped-2d");
  const auto as_3d = [](ParticleSet& gas) { gas.dimension = 3; };
  Outcomes outcomes{try_commands("cut at 0, 1/4, 1/2, 3/4: exit 2", cut, shop),
                    try_commands("2D gas as 3D: runs, note",
                                 {{run_of_gas(shop, "sheet.hdf5", as_3d, {}, 2),
                                   ExitCode::done,
                                   {"all particles have the same z", "Dimension"}}},
                                 shop),
                    try_commands("a stopped run in 3D and in 2D", {stopped_run(run), stopped_run(flat, "2")}, shop)};
  if (!outcomes.back().passed) return outcomes;
  fs::copy_file(flat + "/checkpoint_a.hdf5", run + "/checkpoint_a.hdf5", fs::copy_options::overwrite_existing);
  outcomes.back() = try_commands("checkpoint of another dimension: exit 2",
                                 {{{"run", "--resume", run},
                                   ExitCode::bad_input,
                                   {"checkpoint_a.hdf5", "of another run", "as in scene.used.toml"}}},
                                 shop);
  return outcomes;
}

Outcomes nothing_to_resume(const Workshop& shop) {
  Command complete = stopped_run(shop.path("complete"));
  std::erase(complete.words, "--walltime");
  std::erase(complete.words, "0.001");
  complete.code = ExitCode::done;
  complete.says = {"complete"};
  fs::create_directories(shop.folder / "empty");
  return {try_commands(
      "exit 2: folder, what is missing",
      {complete,
       {{"run", "--resume", shop.path("complete")}, ExitCode::bad_input, {"holds no checkpoint", "output.checkpoint"}},
       {{"run", "--resume", shop.path("empty")}, ExitCode::bad_input, {"empty holds no run", "sphk run"}},
       {{"run", "--resume", shop.path("nowhere")}, ExitCode::bad_input, {"nowhere holds no run", "sphk run"}}},
      shop)};
}

}  // namespace

std::vector<Trial> guards_of_files() {
  return {{"guard-disk", "a full disk", full_disk},
          {"guard-folder", "folders that cannot be made", no_folder},
          {"guard-file", "files cut short, of another dimension", wrong_files},
          {"guard-resume", "nothing to resume", nothing_to_resume}};
}

}  // namespace sphk
