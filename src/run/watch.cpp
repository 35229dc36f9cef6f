// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/watch.hpp"

#include <fmt/format.h>

#include "src/engine/errors.hpp"
#include "src/io/atomic_file.hpp"

namespace sphk {

namespace fs = std::filesystem;

Watch::Watch(const RunOutput& output, Progress& progress, double seconds, bool map)
    : output_(output), progress_(progress), seconds_(seconds), map_(map), folder_(output.folder() / ".watch") {
  fs::create_directories(folder_);
  write_atomically(folder_ / "scene.used.toml", output.info().scene_text);
}

Watch::~Watch() {
  drawing_.reset();
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void Watch::look(const Simulation& simulation) {
  if (drawing_ && drawing_->exit_code()) take();
  if (!drawing_ && !fails_ && clock_.wall() >= next_) draw(simulation);
}

void Watch::finish(const Simulation& simulation) {
  if (drawing_) take();
  if (!fails_) draw(simulation);
  if (drawing_) take();
}

void Watch::draw(const Simulation& simulation) {
  const fs::path snapshot = folder_ / "state.hdf5";
  write_snapshot(snapshot, simulation.view(), output_.info());
  std::vector<std::string> words{this_executable().string(), "plot", snapshot.string(), "--out",
                                 (folder_ / watch_pictures[0]).string()};
  if (map_) words.insert(words.end(), {"--field", "rho"});
  drawing_ = std::make_unique<Process>(
      words, Process::Streams{.output = folder_ / "log.txt", .variables = {{"OMP_NUM_THREADS", "1"}}});
  next_ = clock_.wall() + seconds_;
}

void Watch::take() {
  const int code = drawing_->wait();
  drawing_.reset();
  if (code == 0) {
    for (const char* name : watch_pictures)
      if (fs::exists(folder_ / name)) fs::rename(folder_ / name, output_.folder() / name);
    return;
  }
  if (code >= Process::by_signal) return;  // what ends the run ends its picture as well
  fails_ = true;
  const std::string why = text_of_file(folder_ / "log.txt");
  progress_.say(
      fmt::format("note: --watch cannot draw, and the run goes on without: {}", why.substr(0, why.find('\n'))));
}

}  // namespace sphk
