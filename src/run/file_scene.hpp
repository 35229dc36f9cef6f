#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/io/reader.hpp"
#include "src/scenes/scene.hpp"

namespace sphk {

/// Density, velocity and pressure along x over the whole box: how gas without a scene of its own is drawn.
PlotHint plain_hint(const Box& box);

/// An initial-condition file that runs like a scene: gamma from the file where it says so, no exact solution.
class FileScene : public Scene {
 public:
  static constexpr const char* scene_name = "file";

  /// Reads the file at once; throws InputError when it is no readable initial condition.
  explicit FileScene(const std::filesystem::path& path);

  std::string name() const override { return scene_name; }
  std::string summary() const override;
  /// Declares scene.file and scene.periodic. The end time has no useful default, so time.end is the file's own time.
  void declare(Settings& settings) const override;
  /// Throws InputError listing what check_particles calls an error.
  int dimension(const Settings&) const override { return content_.particles.dimension; }
  ParticleSet build(const Settings& settings) const override;
  PlotHint plot_hint(const Settings& settings) const override;
  /// What the reader assumed, made or left out, and what check_particles noticed.
  const std::vector<std::string>& remarks() const { return content_.remarks; }

 private:
  /// Reads the keys of schemes, terms and time-steps that a snapshot of sphk was made with.
  void read_method();

  std::filesystem::path path_;
  ReadResult content_;
  std::vector<std::string> errors_;
  std::vector<std::pair<std::string, std::string>> method_;  ///< what it goes on with, unless the user asks for another
};

}  // namespace sphk
