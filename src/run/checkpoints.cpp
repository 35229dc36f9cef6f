// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/checkpoints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "src/engine/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/checkpoint.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/report/machine.hpp"
#include "src/run/problem.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array names{"checkpoint_a.hdf5", "checkpoint_b.hdf5"};

/// Calls `each` with every number that a checkpoint holds beside the simulation, and its name there.
void visit(auto&& each, auto& loop, auto& output, auto& box) {
  each("begin", loop.begin), each("steps", loop.steps), each("wall", loop.wall), each("cpu", loop.cpu);
  each("joules", loop.joules);
  each("next_snapshot", loop.next_snapshot), each("next_row", loop.next_row);
  each("next_heating", loop.next_heating);
  each("snapshot_times", output.snapshot_times), each("history_bytes", output.history_bytes);
  each("last_step", output.last_step), each("output_seconds", output.seconds);
  each("box_lower", box.lower), each("box_size", box.size), each("box_periodic", box.periodic);
}

struct Writer {
  Json json;
  void operator()(const char* name, const auto& value) { json[name] = value; }
  void operator()(const char* name, const std::optional<double>& value) { json[name] = value ? Json(*value) : Json(); }
};

struct Reader {
  const Json json;
  void operator()(const char* name, auto& value) const { json.at(name).get_to(value); }
  void operator()(const char* name, std::optional<double>& value) const {
    if (!json.at(name).is_null()) value = json.at(name).get<double>();
  }
};

/// Throws InputError where the scene differs, or a key that decides what is computed.
void require_same_run(const fs::path& path, const Scene& scene, const Settings& settings) {
  const hdf5::File file = hdf5::File::open(path);
  const auto require_same = [](const std::string& what, const std::string& there, const std::string& here) {
    if (here != there)
      throw InputError(fmt::format("it is of another run, of which {} is \"{}\", not \"{}\" as in scene.used.toml",
                                   what, there, here));
  };
  require_same("the scene", file.group("sphk").text("Scene"), scene.name());
  const hdf5::Group saved = file.group("Parameters");
  for (const Key& key : settings.keys()) {
    if (may_change(key.name)) continue;
    std::string name = key.name;
    std::ranges::replace(name, '.', ':');
    const auto* text = std::get_if<std::string>(&key.value);
    require_same(key.name, saved.has_attribute(name) ? saved.text(name) : "", text ? *text : sphk::to_text(key.value));
  }
}

/// The step and the scene of a checkpoint, which its metadata tell; nothing where it cannot be read.
std::optional<std::pair<double, SavedScene>> scene_of(const fs::path& path) {
  try {
    const hdf5::File file = hdf5::File::open(path);
    const hdf5::Group own = file.group("sphk");
    return std::pair(own.numbers("Step").at(0), SavedScene{own.text("SceneText"), path});
  } catch (const std::exception&) {  // newest_checkpoint says why
    return std::nullopt;
  }
}

}  // namespace

std::optional<SavedScene> newest_scene(const fs::path& folder) {
  std::optional<std::pair<double, SavedScene>> newest;
  for (const char* name : names) {
    const auto found = fs::exists(folder / name) ? scene_of(folder / name) : std::nullopt;
    if (found && (!newest || found->first > newest->first)) newest = found;
  }
  return newest ? std::optional(newest->second) : std::nullopt;
}

void restore_files(const fs::path& folder, const SavedRun& saved) {
  if (text_of_file(folder / "history.csv").substr(0, saved.history.size()) != saved.history)
    write_atomically(folder / "history.csv", saved.history);
  if (is_cut_short(text_of_file(folder / "scene.used.toml"), saved.scene))
    write_atomically(folder / "scene.used.toml", saved.scene);
}

Checkpoints::Checkpoints(fs::path folder, const fs::path& last)
    : folder_(std::move(folder)), next_(last.filename() == names[0] ? 1 : 0) {}

void Checkpoints::write(const Simulation& simulation, const LoopState& loop, const OutputState& output, const Box& box,
                        const SnapshotInfo& info) {
  const Stopwatch watch;
  Writer text;
  visit(text, loop, output, box);
  const Checkpoint around{text.json.dump(), text_of_file(folder_ / "history.csv").substr(0, output.history_bytes),
                          info.scene_text};
  const auto save = [&](const TakeBlock& take) { simulation.save(take); };
  write_checkpoint(folder_ / names[next_], around, save, simulation.view(), info);
  next_ = 1 - next_;
  seconds_ = watch.wall();
}

bool Checkpoints::any() const {
  return std::ranges::any_of(names, [this](const char* name) { return fs::exists(folder_ / name); });
}

void Checkpoints::remove() const {
  for (const char* name : names) fs::remove(folder_ / name);
}

SavedRun newest_checkpoint(const fs::path& folder, const Scene& scene, const Settings& settings) {
  std::optional<SavedRun> newest;
  std::vector<std::string> remarks;
  for (const char* name : names) {
    const fs::path file = folder / name;
    if (!fs::exists(file)) continue;
    try {
      Checkpoint checkpoint = read_checkpoint(file);
      require_same_run(file, scene, settings);
      SavedRun run;
      visit(Reader{Json::parse(checkpoint.loop)}, run.loop, run.output, run.box);
      if (newest && newest->loop.steps >= run.loop.steps) continue;
      run.file = file;
      run.simulation = std::move(checkpoint.simulation);
      run.history = checkpoint.history;
      run.scene = checkpoint.scene;
      newest = std::move(run);
    } catch (const std::exception& error) {
      remarks.push_back(fmt::format("{} cannot be used: {}", name, error.what()));
    }
  }
  if (!newest)
    throw InputError(fmt::format("{} holds no checkpoint to go on from{}", folder.string(),
                                 remarks.empty() ? ": a run leaves one when it is stopped, and every "
                                                   "output.checkpoint seconds"
                                                 : fmt::format(":\n  {}", fmt::join(remarks, "\n  "))));
  newest->remarks = std::move(remarks);
  return std::move(*newest);
}

}  // namespace sphk
