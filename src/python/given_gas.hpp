// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/run/file_scene.hpp"
#include "src/run/problem.hpp"

namespace sphk::python {

/// Gas that a program hands over, as a scene: named and run like the initial condition of a file, which the first
/// snapshot of its run's folder is. It has no particles of its own.
class GivenGas : public Scene {
 public:
  static constexpr const char* file_key = "scene.file";

  explicit GivenGas(const ParticleSet& gas) : dimension_(gas.dimension), time_(gas.time), box_(gas.box) {}

  std::string name() const override { return FileScene::scene_name; }
  std::string summary() const override { return "particles of a Python program"; }
  void declare(Settings& settings) const override {
    settings.declare({.name = file_key, .value = std::string(), .doc = "the initial condition", .choices = {}});
    settings.prefer("time.end", time_);
  }
  int dimension(const Settings&) const override { return dimension_; }
  ParticleSet build(const Settings&) const override { return {.dimension = dimension_, .box = box_, .time = time_}; }
  PlotHint plot_hint(const Settings&) const override { return plain_hint(box_); }

 private:
  int dimension_;
  double time_;
  Box box_;
};

}  // namespace sphk::python
