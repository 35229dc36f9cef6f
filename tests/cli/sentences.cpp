// SPDX-License-Identifier: BSD-3-Clause

// What a user gets who types something else than was meant: the sentence, or what was meant where there is no doubt.
#include <nlohmann/json.hpp>

#include "tests/cli/sphk_executable.hpp"

namespace sphk {
namespace {

namespace fs = std::filesystem;

constexpr int bad_input = 2;
const std::string gas = "run uniform -n 6 --set scene.lattice=cubic ";

class Sentences : public Executable {
 protected:
  nlohmann::json record(const std::string& run) const {
    return nlohmann::json::parse(read_text(file(run + "/run.json")));
  }
};

TEST_F(Sentences, AKeyThatIsGivenTwiceIsRefusedWithBothSpellings) {
  expect(gas + "--set sph.kernel=cs --kernel wc2", bad_input,
         {"--kernel wc2", "--set sph.kernel=cs", "both set sph.kernel"});
  expect(gas + "--set time.end=1 --set time.end=2", bad_input, {"--set time.end=1 and --set time.end=2"});
  expect(gas + "--scheme gadget2 --set sph.scheme=SPHS-HCT442", bad_input, {"both set sph.scheme"});
  expect("study sod --set sph.kernel=cs --kernel wc2,ct", bad_input, {"sph.kernel is given twice"});
  expect("study sod --vary sph.kernel=cs --kernel wc2", bad_input, {"sph.kernel is given twice"});
}

TEST_F(Sentences, NamesAreKnownInAnyCaseAndWithTheirNeighbours) {
  expect(gas + "--steps 1 --scheme GADGET2 --kernel WC4 --precision DOUBLE --out a", 0, {"scheme gadget2, kernel wc4"});
  expect(gas + "--steps 1 --scheme gadget2 --kernel WC2-100 --out b", 0, {"kernel wc2, 100 neighbours"});
  expect(gas + "--steps 1 --scheme gadget2 --kernel WC2-100 --neighbours 80 --out c", 0, {"kernel wc2, 80 neighbours"});
  std::ofstream(file("my.toml")) << "scene = \"uniform\"\nsph.kernel = \"WC4\"\nsph.scheme = \"Gadget2\"\n";
  expect("run my.toml -n 6 --set scene.lattice=cubic --steps 1 --out d", 0, {"scheme gadget2, kernel wc4"});
}

TEST_F(Sentences, ANameIsOfferedWhereOneIsNear) {
  std::ofstream(file("my.toml")) << "scene = \"uniform\"\n[sph]\nviscosty = 3\n";
  expect("run my.toml", bad_input, {"my.toml:3:1", "did you mean \"viscosity."});
  expect("run sod --set sph.aplha=1", bad_input, {"did you mean \"viscosity.alpha\""});
  for (const std::string words : {"run sod --quiet", "run sod --set sph.xyzzy=1", "run banana"}) {
    const Result result = sphk(words);
    EXPECT_EQ(result.code, bad_input);
    EXPECT_EQ(result.text.find("did you mean"), std::string::npos) << result.text;
  }
}

TEST_F(Sentences, NoStepIsNoStep) {
  expect(gas + "--steps 0 --out none", 0, {"complete"});
  EXPECT_EQ(record("none")["steps"], 0);
  EXPECT_FALSE(fs::exists(file("none/snap_0001.hdf5")));
}

TEST_F(Sentences, PathsAndFiguresThatCannotBeAreRefusedAtOnce) {
  expect(gas + "--out ''", bad_input, {"--out \"\"", "a name is wanted"});
  expect(gas + "--steps 1 --out run", 0, {"complete"});
  for (const std::string out : {"x.gif", "run/x.txt"})
    expect("plot run --out " + out, bad_input,
           {"figures are .png, .pdf, .svg or .jpg files", fs::path(out).replace_extension(".png")});
  EXPECT_FALSE(fs::exists(file("x.gif")));
}

TEST_F(Sentences, AStudyByANormThatNobodyMeasuresDoesNotBegin) {
  for (const std::string norm : {"banana", "banana_particles"})
    expect("study sod -n 16 --norm " + norm, bad_input, {"\"" + norm + "\"", "--norm v"});
  EXPECT_FALSE(fs::exists(file("sod-study")));
}

TEST_F(Sentences, NumbersWithoutEndAreRefused) {
  expect(gas + "--t-end inf", bad_input, {"--t-end inf", "finite"});
  expect(gas + "--set output.checkpoint=inf", bad_input, {"finite"});
}

TEST_F(Sentences, ASceneFileFindsTheInitialConditionBesideIt) {
  expect(gas + "--steps 1 --out run", 0, {"complete"});
  fs::create_directories(file("below"));
  fs::rename(file("run/snap_0001.hdf5"), file("below/ok.hdf5"));
  std::ofstream(file("below/short.toml")) << "scene = \"ok.hdf5\"\ntime.end = 0.5\n";
  std::ofstream(file("below/long.toml")) << "[scene]\nname = \"file\"\nfile = \"ok.hdf5\"\n[time]\nend = 0.5\n";
  for (const std::string name : {"short", "long"}) {
    expect("run below/" + name + ".toml --steps 1 --out " + name, 0, {"complete"});
    expect("run " + name + "/scene.used.toml --out again-" + name, 0, {"complete"});
  }
  std::ofstream(file("below/other.toml")) << "scene = \"none.hdf5\"\n";
  expect("run below/other.toml", bad_input, {"below/none.hdf5"});
}

TEST_F(Sentences, TheLastStepIsToldOnceAndTheFinalTableAgain) {
  const Result run = sphk(gas + "--steps 1 --out run");
  ASSERT_EQ(run.code, 0) << run.text;
  const auto first = run.text.find("\nstep ");
  ASSERT_NE(first, std::string::npos) << run.text;
  EXPECT_EQ(run.text.find("\nstep ", first + 1), std::string::npos) << run.text;
  const auto begin = run.text.find("  phase "), end = run.text.find("run is complete");
  ASSERT_NE(begin, std::string::npos);
  expect("info run", 0, {run.text.substr(begin, end - begin)});
  fs::create_directories(file("empty"));
  expect("info empty", bad_input, {"empty holds no run.json"});
}

TEST_F(Sentences, MoreThreadsThanKokkosTakesAreCapped) {
  expect(gas + "--steps 1 --threads 1000 --out a", 0, {"1000 threads are asked for", "complete"});
  setenv("OMP_NUM_THREADS", "1000", 1);
  expect("rates a/snap_0001.hdf5 --out r.hdf5", 0, {"1000 threads are asked for", "216 particles"});
  setenv("OMP_NUM_THREADS", "1", 1);
}

TEST_F(Sentences, OddVariablesOfKokkosAreNamed) {
  const std::pair<const char*, const char*> odd[] = {{"KOKKOS_NUM_THREADS", "many"},
                                                     {"KOKKOS_NUM_THREADS", "0"},
                                                     {"KOKKOS_DEVICE_ID", "-1"},
                                                     {"KOKKOS_TUNE_INTERNALS", "maybe"},
                                                     {"KOKKOS_MAP_DEVICE_ID_BY", "luck"}};
  for (const auto& [name, value] : odd) {
    setenv(name, value, 1);
    expect(gas + "--steps 1", bad_input, {std::string(name) + "=" + value, "unset"});
    unsetenv(name);
  }
}

}  // namespace
}  // namespace sphk
