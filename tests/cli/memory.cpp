// SPDX-License-Identifier: BSD-3-Clause

// What runs hold in memory at their peak, beside what their particles take on the device.
#include <nlohmann/json.hpp>

#include "tests/cli/sphk_executable.hpp"

namespace sphk {
namespace {

class Memory : public Executable {
 protected:
  /// The run of the folder held no more than 1.35 times the bytes of its particles, and 60 MB for the program.
  void expect_little(const std::string& name) const {
    const auto json = nlohmann::json::parse(read_text(file(name + "/run.json")));
    const double particles = json["particles"], bytes = json["bytes_per_particle"], peak = json["peak_memory_bytes"];
    EXPECT_GT(peak, particles * bytes) << name;
    EXPECT_LT(peak, 1.35 * particles * bytes + 60e6) << name << ", " << particles << " particles of " << bytes;
  }
};

/// With snapshots at the start and the end, rows of the history, the scenes' measures and exact solutions.
TEST_F(Memory, OfARunIsLittleMoreThanItsParticles) {
  const std::pair<const char*, const char*> runs[] = {
      {"uniform", "uniform -n 64 --scheme sph"},
      {"own-steps", "sedov -n 64 --scheme sphs --kernel cs --neighbours 48"},
      {"plane", "gresho -n 400 --set scene.dimension=2 --scheme sph --kernel cs --neighbours 20"},
      {"layers", "kh12 -n 400 --set scene.dimension=2 --scheme sph --kernel cs --neighbours 20"},
      {"line", "uniform -n 100000 --set scene.dimension=1 --scheme sph --kernel cs --neighbours 8"},
  };
  for (const auto& [name, arguments] : runs) {
    const Result result = sphk(std::string("run ") + arguments + " --steps 1 --out " + name);
    ASSERT_EQ(result.code, 0) << result.text;
    expect_little(name);
  }
}

/// A checkpoint is written, and read again, block by block.
TEST_F(Memory, OfCheckpointsIsNoMore) {
  const Result stopped = sphk("run uniform -n 64 --scheme sph --kernel cs --neighbours 48 --walltime 0.01 --out run");
  ASSERT_EQ(stopped.code, 75) << stopped.text;
  ASSERT_TRUE(std::filesystem::exists(file("run/checkpoint_a.hdf5")));
  expect_little("run");
  ASSERT_EQ(sphk("run --resume run --walltime 0.01").code, 75);
  expect_little("run");
}

/// A file's particles are let go of once they run.
TEST_F(Memory, OfAFileIsNoMore) {
  ASSERT_EQ(sphk("run uniform -n 64 --scheme sph --kernel cs --neighbours 48 --steps 1 --out first").code, 0);
  ASSERT_EQ(sphk("run first/snap_0001.hdf5 --steps 1 --t-end 1 --out second").code, 0);
  expect_little("second");
}

}  // namespace
}  // namespace sphk
