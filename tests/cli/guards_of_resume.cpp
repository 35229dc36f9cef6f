// SPDX-License-Identifier: BSD-3-Clause

// What stops a run in the middle and what cannot be resumed: no room on the disk, checkpoints of another run, nothing.
#include <sys/resource.h>

#include <array>
#include <fstream>

#include "tests/cli/sphk_executable.hpp"

namespace sphk {
namespace {

namespace fs = std::filesystem;

constexpr int bad_input = 2, stopped = 75;
const std::string lattice = "run uniform -n 8 --set scene.lattice=cubic ";

/// Files may not grow beyond so many bytes, in this process and those that it starts. A write then fails as on a full
/// disk.
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

class Resume : public Executable {
 protected:
  /// A run of 8^3 particles that is stopped after its first step, with a checkpoint.
  void stop_a_run(const std::string& out, const std::string& dimension = "3") const {
    expect(
        lattice + "--set output.checkpoint=1e-9 --walltime 0.001 --set scene.dimension=" + dimension + " --out " + out,
        stopped, {"sphk run --resume"});
  }
  /// One line of the run's scene.used.toml, by its beginning.
  void rewrite(const std::string& old_line, const std::string& new_line) const {
    std::ifstream in(file("run/scene.used.toml"));
    std::string text{std::istreambuf_iterator<char>(in), {}};
    const auto place = text.find("\n" + old_line);
    ASSERT_NE(place, std::string::npos) << old_line;
    text.replace(place + 1, old_line.size(), new_line);
    std::ofstream(file("run/scene.used.toml")) << text;
  }
};

TEST_F(Resume, GoesOnFromTheOlderCheckpointOnceThereIsRoomOnTheDiskAgain) {
  stop_a_run("run");
  const auto snapshot = fs::file_size(file("run/snap_0000.hdf5")),
             checkpoint = fs::file_size(file("run/checkpoint_a.hdf5"));
  {
    const FileSizeLimit limit(snapshot / 2);
    expect(lattice + "--out other", bad_input, {"other/snap_0000.hdf5", "cannot be written", "make room"});
  }
  {
    const FileSizeLimit limit((snapshot + checkpoint) / 2);
    expect("run --resume run", bad_input,
           {"run/checkpoint_b.hdf5", "cannot be written", "make room", "sphk run --resume run"});
  }
  expect("run --resume run", 0, {"checkpoint_a.hdf5, step 1", "complete"});
}

TEST_F(Resume, RefusesACheckpointOfAnotherDimension) {
  stop_a_run("run");
  stop_a_run("flat", "2");
  fs::copy_file(file("flat/checkpoint_a.hdf5"), file("run/checkpoint_a.hdf5"), fs::copy_options::overwrite_existing);
  expect("run --resume run", bad_input, {"checkpoint_a.hdf5", "of another run", "as in scene.used.toml"});
}

/// Only the end, the number of steps and the output may change: a run that went on with another equation would pass for
/// one that had it from the start.
TEST_F(Resume, RefusesAKeyThatDecidesWhatIsComputed) {
  stop_a_run("run");
  for (const auto& [key, line, other] :
       std::vector<std::array<std::string, 3>>{{"viscosity.alpha", "alpha = 1", "alpha = 5"},
                                               {"viscosity.balsara", "balsara = true", "balsara = false"},
                                               {"time.courant", "courant = 0.4", "courant = 0.1"},
                                               {"time.steps", "steps = \"global\"", "steps = \"individual\""},
                                               {"gravity.central_mass", "central_mass = 0", "central_mass = 1"},
                                               {"sph.neighbours", "neighbours = 48", "neighbours = 60"}}) {
    rewrite(line, other);
    expect("run --resume run", bad_input, {"of another run, of which " + key + " is"});
    rewrite(other, line);
  }
  rewrite("end = 0.1", "end = 0.02");
  rewrite("snapshots = 10", "snapshots = 1");
  expect("run --resume run", 0, {"complete"});
}

TEST_F(Resume, SaysWhatIsMissingWhereThereIsNothingToResume) {
  expect(lattice + "--set output.checkpoint=1e-9 --out complete", 0, {"complete"});
  fs::create_directories(file("empty"));
  expect("run --resume complete", bad_input, {"holds no checkpoint", "output.checkpoint"});
  expect("run --resume empty", bad_input, {"empty holds no run", "sphk run"});
  expect("run --resume nowhere", bad_input, {"nowhere holds no run", "sphk run"});
}

}  // namespace
}  // namespace sphk
