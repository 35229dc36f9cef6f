// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/io/check.hpp"
#include "src/scenes/scene.hpp"

namespace sphk {

/// Density, velocity and pressure along x over the whole box: how gas without a scene of its own is drawn.
PlotHint plain_hint(const Box& box);

/// An initial-condition file that runs like a scene: gamma and units from the file where it says them,
/// no exact solution.
class FileScene : public Scene {
 public:
  static constexpr const char* scene_name = "file";

  /// Reads the file at once, to judge it, and again for build(): particles are not kept in between. Throws InputError
  /// when it is no readable initial condition.
  explicit FileScene(const std::filesystem::path& path) : FileScene(path, path) {}
  /// The same with another file's particles, such as those of a later snapshot.
  FileScene(const std::filesystem::path& path, const std::filesystem::path& particles);

  std::string name() const override { return scene_name; }
  std::string summary() const override;
  /// Declares scene.file, scene.dimension and scene.periodic. The end time has no useful default, so time.end is the
  /// file's own time.
  void declare(Settings& settings) const override;
  /// Throws InputError listing what judge() calls an error, and where the number of dimensions is in doubt.
  ParticleSet build(const Settings& settings) const override;
  PlotHint plot_hint(const Settings& settings) const override;
  /// What the reader assumed, made or left out, and what is rarely meant.
  const std::vector<std::string>& remarks() const { return verdict_.notes; }
  /// The file's own; none where it does not say them, or they are those of the code.
  const std::optional<Units>& units() const { return content_.units; }

 private:
  /// Reads the keys of schemes, terms and time-steps that a snapshot of sphk was made with.
  void read_method(const std::filesystem::path& snapshot);
  /// Makes the gas one of as many dimensions as are asked for.
  void set_dimension(ParticleSet& gas, const Settings& settings) const;

  std::filesystem::path path_, particles_;
  ReadResult content_;  ///< without the particles
  Verdict verdict_;
  std::string doubt_;                                        ///< about the number of dimensions
  std::vector<std::pair<std::string, std::string>> method_;  ///< what it goes on with, unless the user asks for another
};

}  // namespace sphk
