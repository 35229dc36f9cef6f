// SPDX-License-Identifier: BSD-3-Clause

// fuzz_seeds FOLDER: small valid files to begin with, in FOLDER/toml and FOLDER/hdf5.
#include <cstdio>
#include <fstream>
#include <vector>

#include "src/io/checkpoint.hpp"
#include "src/run/scene_file.hpp"
#include "tests/io/example.hpp"

namespace sphk {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t particles = 8;

void write_texts(const fs::path& folder) {
  const auto write = [&](const char* name, const std::string& text) { std::ofstream(folder / name) << text; };
  write("used", used_scene_file(example_info().settings, "example"));
  write("scene",
        "scene = \"sod\"\n[sph]\nkernel = 'hoct4'\nneighbours = 442\ngamma = 1.4e0\nenergy = \"energy\"\n"
        "[time]\nmotion = false\nend = 0.2\n[output]\nsnapshots = 0x10\n");
  write("dotted", "scene.name = \"noh\"\nscene.n = 1_000\nscene.lattice = \"\"\"cubic\"\"\"\ntime = {end = inf}\n");
  write("wrong", "[scene]\nname = 1979-05-27T07:32:00Z\nn = [1, 2]\n[spc]\nkernal = \"\\u00e9\"\n");
  write("study",
        "scene = \"sod\"\nsummary = \"all\"\nnorm = \"rho\"\ntarget = 0.5\nbudgets = [1, 60.5]\nrepeat = 2\n"
        "others = \"peers.csv\"\n[set]\nscene = { lattice = \"cubic\", across = 4 }\ntime.limiter = false\n"
        "[vary]\nscene.n = [16, 32]\n[[methods]]\nsph.scheme = [\"sph\", \"tsph\"]\nsph.neighbours = 48\n"
        "[[methods]]\nviscosity.alpha = 0.5\n");
  write("extremes",
        "scene = \"sod\"\n[set]\nscene = { n = 32 }\n[require]\nunsound.below = 1\n[[case]]\nname = \"stiff\"\n"
        "summary = \"short\"\nset.sph.kernel = \"m6\"\nrequire.energy = { below = 1e-3, above = -1 }\n"
        "[[case]]\nname = \"other\"\n[case.set]\ntime.motion = false\n[case.require]\nmach = \"recorded\"\n");
  write("others", "# last year\nmachine,error,engine, setting ,cpu_seconds\nA box, 0.5 ,SWIFT,48 neighbours,2e1\r\n");
}

/// An initial condition with all that the reader looks for.
hdf5::File full_ic() {
  hdf5::File file = ExampleIc{.n = particles, .columns = 2}.make();
  hdf5::Group header = file.group("Header");
  header.set("NumFilesPerSnapshot", std::int32_t{1});
  header.set("MassTable", std::vector<double>{0.5, 0, 0, 0, 0, 0});
  header.set("Time", 0.25);
  header.set("Redshift", 0.5);
  header.set("Dimension", std::int32_t{2});
  header.set("Flag_Entropy_ICs", std::int32_t{0});
  file.create_group("RuntimePars").set("PeriodicBoundariesOn", std::int32_t{1});
  file.create_group("Cosmology").set("Cosmological run", std::int32_t{0});
  file.create_group("HydroScheme").set("Adiabatic index", 1.4);
  file.create_group("Units").set("Unit length in cgs (U_L)", 1.0);
  hdf5::Group gas = file.group("PartType0");
  gas.write("SmoothingLength", std::vector<float>(particles, 0.5F), 1, true);
  gas.write("ParticleIDs", std::vector<std::int32_t>{1, 2, 3, 4, 5, 6, 7, 8});
  file.create_group("PartType1").write("Coordinates", std::vector<float>(6), 3);
  return file;
}

/// What the reader asks of a snapshot and of a checkpoint, without all that other programs want: small enough to fuzz.
hdf5::File small_snapshot() {
  hdf5::File file = ExampleIc{.n = particles, .columns = 1}.make();
  hdf5::Group own = file.create_group("sphk");
  own.set("BoxLower", std::vector<double>(3, 0));
  own.set("BoxSize", std::vector<double>(3, 2));
  own.set("Periodic", std::vector<std::int32_t>{1, 0, 0});
  own.set("Dimension", std::int32_t{1});
  own.set("Step", std::int64_t{17});
  own.set("Scene", "sod");
  file.group("PartType0").write("SmoothingLength", std::vector<double>(particles, 0.5));
  file.group("PartType0").write("Alpha", std::vector<float>(particles, 0.5F), 0, true);
  hdf5::Group state = own.create_group("Checkpoint");
  state.write("x", std::vector<std::uint8_t>{1, 2, 3, 4});
  state.write("Loop", std::vector<std::uint8_t>{'{', '}'});
  state.write("Checksum", std::vector<std::uint64_t>{0});  // wrong: the sum is the last thing that is looked at
  return file;
}

void write_hdf5(const fs::path& folder) {
  ExampleIc{.n = particles, .columns = 1}.make().save(folder / "ic");
  full_ic().save(folder / "full");
  small_snapshot().save(folder / "small");
  hdf5::File::create().save(folder / "empty");
  Snapshot snapshot = example_snapshot(1, particles);
  write_snapshot(folder / "snapshot", snapshot, example_info());
  write_snapshot(folder / "compressed", snapshot, example_info(), Compression::gzip);
  const auto save = [](const TakeBlock& take) {
    take("x", std::vector<std::uint8_t>{1, 2, 3, 4});
    take("t", std::vector<std::uint8_t>{5});
  };
  write_checkpoint(folder / "checkpoint", {.loop = "{}", .history = "step\n", .scene = {}}, save, snapshot,
                   example_info());
}

}  // namespace
}  // namespace sphk

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: fuzz_seeds FOLDER\n", stderr);
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder / "toml");
  std::filesystem::create_directories(folder / "hdf5");
  sphk::write_texts(folder / "toml");
  sphk::write_hdf5(folder / "hdf5");
  return 0;
}
