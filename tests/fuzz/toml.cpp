// SPDX-License-Identifier: BSD-3-Clause

// The readers of text: scene files, study files, files of extremes, and the tables of other engines.
#include "src/run/scene_file.hpp"
#include "src/study/extremes.hpp"
#include "src/study/others.hpp"
#include "src/study/plan.hpp"
#include "tests/fuzz/input_file.hpp"

namespace sphk {
namespace {

/// A key of every type and kind of limit: the registry of the schemes would bring all their kernels along.
Settings some_settings() {
  Settings settings;
  settings.declare({"sph.kernel", std::string("cs"), "any string", {}});
  settings.declare({"sph.energy", std::string("entropy"), "a choice", {"entropy", "energy"}});
  settings.declare({"sph.neighbours", 48.0, "a number", {}, 1, 1e6});
  settings.declare({"sph.gamma", 5.0 / 3, "a number", {}, 1.0000001, 100});
  settings.declare({"time.motion", true, "a flag", {}});
  settings.declare({"time.end", 1.0, "any number", {}});
  settings.declare({"output.snapshots", std::int64_t{10}, "an integer", {}, 1, 9999});
  settings.declare({"scene.n", std::int64_t{64}, "an integer", {}, 2, 100000});
  settings.declare({"scene.lattice", std::string("glass"), "a choice", {"cubic", "glass"}});
  return settings;
}

void read_scene_file(const std::filesystem::path& path) {
  const SceneFile file(path);
  if (const SceneFileEntry* scene = file.scene()) {
    file.message(*scene, "a problem", true);
    file.message(*scene, "a problem", false);
  }
  file.text("scene.file");
  Settings settings = some_settings();
  if (!file.apply(settings).empty()) return;
  std::ofstream(path) << used_scene_file(settings, "sod");  // what a run writes beside its results must read back
  Settings again = some_settings();
  if (!SceneFile(path).apply(again).empty()) __builtin_trap();
  for (std::size_t k = 0; k < again.keys().size(); ++k)
    if (again.keys()[k].value != settings.keys()[k].value) __builtin_trap();
}

void read_plan(const std::filesystem::path& path) {
  is_study_file(path);
  for (const StudyPoint& point : read_study_file(path).points) {
    point.name();
    point.method();
  }
}

void read_cases(const std::filesystem::path& path) {
  const auto check = [](const std::string&, const KeyTexts& keys) {
    Settings settings = some_settings();
    for (const auto& [key, text] : keys) settings.set_from_text(key, text, Origin::file);
  };
  for (const ExtremeCase& one : read_extremes(path, check))
    for (const Requirement& requirement : one.requirements) requirement.text();
}

}  // namespace
}  // namespace sphk

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const sphk::InputFile file(".toml");
  file.put(data, size);
  sphk::expect_input_error_or_none([] { sphk::read_plan(file.path()); });
  sphk::expect_input_error_or_none([] { sphk::read_cases(file.path()); });
  sphk::expect_input_error_or_none([] { sphk::read_others(file.path()); });
  sphk::expect_input_error_or_none([] { sphk::read_scene_file(file.path()); });
  return 0;
}
