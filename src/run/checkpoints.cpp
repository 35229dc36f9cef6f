#include "src/run/checkpoints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "src/engine/errors.hpp"
#include "src/io/checkpoint.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/report/machine.hpp"
#include "src/run/problem.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array names{"checkpoint_a.hdf5", "checkpoint_b.hdf5"};

std::string to_text(const LoopState& loop, const OutputState& output, const Box& box) {
  return Json{{"begin", loop.begin},
              {"steps", loop.steps},
              {"wall", loop.wall},
              {"cpu", loop.cpu},
              {"joules", loop.joules ? Json(*loop.joules) : Json(nullptr)},
              {"next_snapshot", loop.next_snapshot},
              {"next_row", loop.next_row},
              {"next_heating", loop.next_heating},
              {"snapshot_times", output.snapshot_times},
              {"history_bytes", output.history_bytes},
              {"last_step", output.last_step},
              {"output_seconds", output.seconds},
              {"box_lower", box.lower},
              {"box_size", box.size},
              {"box_periodic", box.periodic}}
      .dump();
}

SavedRun from_text(const std::string& text) {
  const Json json = Json::parse(text);
  SavedRun run;
  run.loop = {.begin = json["begin"],
              .steps = json["steps"],
              .wall = json["wall"],
              .cpu = json["cpu"],
              .joules = json["joules"].is_null() ? std::nullopt : std::optional<double>(json["joules"]),
              .next_snapshot = json["next_snapshot"],
              .next_row = json["next_row"],
              .next_heating = json["next_heating"]};
  run.output = {.snapshot_times = json["snapshot_times"],
                .history_bytes = json["history_bytes"],
                .last_step = json["last_step"],
                .seconds = json["output_seconds"]};
  run.box = {json["box_lower"], json["box_size"], json["box_periodic"]};
  return run;
}

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

}  // namespace

Checkpoints::Checkpoints(fs::path folder, const fs::path& last)
    : folder_(std::move(folder)), next_(last.filename() == names[0] ? 1 : 0) {}

void Checkpoints::write(const Simulation& simulation, const LoopState& loop, const OutputState& output, const Box& box,
                        const SnapshotInfo& info) {
  const Stopwatch watch;
  write_checkpoint(folder_ / names[next_], {simulation.save(), to_text(loop, output, box)}, simulation.snapshot(),
                   info);
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
      const Checkpoint checkpoint = read_checkpoint(file);
      require_same_run(file, scene, settings);
      SavedRun run = from_text(checkpoint.loop);
      if (newest && newest->loop.steps >= run.loop.steps) continue;
      run.file = file;
      run.simulation = checkpoint.state;
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
