// SPDX-License-Identifier: BSD-3-Clause

// Every particle's sums are made by one thread, in an order that the cells set: one thread and two give the same bits.
#include <gtest/gtest.h>

#include <cstdlib>

#include "src/io/reader.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

ParticleSet end_of_run(const std::filesystem::path& folder, const std::string& arguments, int threads) {
  const std::string out = (folder / std::to_string(threads)).string();
  const std::string command = "env -u OMP_NUM_THREADS '" SPHK_EXECUTABLE "' run " + arguments + " --threads " +
                              std::to_string(threads) + " --set output.snapshots=1 --out '" + out +
                              "' > /dev/null 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  return read_particles(out + "/snap_0001.hdf5").particles;
}

class Threads : public testing::TestWithParam<std::string> {};

TEST_P(Threads, OfAnyNumberGiveTheSameBits) {
  const TemporaryFolder folder;
  const ParticleSet one = end_of_run(folder.path(), GetParam(), 1), two = end_of_run(folder.path(), GetParam(), 2);
  ASSERT_GT(one.size(), 100u);
  EXPECT_GT(one.time, 0);
  EXPECT_EQ(one.time, two.time);
  EXPECT_EQ(one.x, two.x);
  EXPECT_EQ(one.v, two.v);
  EXPECT_EQ(one.u, two.u);
  EXPECT_EQ(one.h, two.h);
}

const std::string shaken =
    "uniform -n 14 --scheme gadget2 --steps 12 --set scene.lattice=cubic --set scene.jitter=0.2 --precision ";
INSTANTIATE_TEST_SUITE_P(Precisions, Threads, testing::Values(shaken + "mixed", shaken + "double"));

const std::string odd = "odd --steps 12 --set time.steps=individual --set scene.problem=";
INSTANTIATE_TEST_SUITE_P(OddArrangements, Threads,
                         testing::Values(odd + "plane --scheme gadget2", odd + "ten --scheme sphs",
                                         odd + "ejected --scheme sphs"));

}  // namespace
}  // namespace sphk
