// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/scenes/block.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/norms.hpp"
#include "src/scenes/riemann.hpp"
#include "src/scenes/scenes.hpp"

namespace sphk {

namespace {

/// A Riemann problem between walls, or with free ends.
struct TubeProblem {
  const char* name;
  TubeState left, right;
  double gamma, end;
  double lower, jump, upper;
  const char* source;
  bool walls = true;
};

constexpr TubeProblem problems[] = {
    {"blast", {1, 0, 1000}, {1, 0, 0.01}, 1.4, 0.0075, 0, 0.5, 1, "Toro 2009, test 3"},
    {"strong-blast", {1, 0, 3000}, {1, 0, 1e-7}, 1.4, 0.015, -1.2, 0, 1.2, "pressures of 3e10"},
    {"rarefactions", {1, -2, 0.4}, {1, 2, 0.4}, 1.4, 0.15, -1, 0.5, 2, "Einfeldt's 1-2-0-3; Toro 2009, test 2", false},
    {"leblanc", {1, 0, 0.2 / 3}, {1e-3, 0, 0.2 / 3 * 1e-9}, 5.0 / 3, 6, 0, 3, 9, "density 1:1000, pressure 1:1e9"},
    {"slow-shock", {27.0 / 7, -0.810631, 31.0 / 3}, {1, -3.44, 1}, 1.4, 0.5, -3, 0, 3, "Quirk 1994: speed 0.11", false},
    {"streams", {1, 1, 0}, {1, -1, 0}, 5.0 / 3, 1, -2, 0, 2, "streams of scene.mach that collide", false},
    {"double-blast", {1, 0, 1000}, {1, 0, 0.01}, 1.4, 0.038, 0, 0.1, 1, "Woodward & Colella 1984; P = 100 from 0.9 on"},
};

std::string list_of_problems() {
  std::string text;
  for (const TubeProblem& problem : problems)
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", problem.name, problem.source);
  return text;
}

const TubeProblem& named(const std::string& name) {
  return *std::ranges::find_if(problems, [&](const TubeProblem& problem) { return name == problem.name; });
}

TubeProblem problem_of(const Settings& settings) {
  TubeProblem problem = named(settings.text("scene.problem"));
  problem.gamma = settings.real("sph.gamma");
  if (std::string(problem.name) == "streams") {  // speed 1, sound 1 / mach
    const double mach = settings.real("scene.mach");
    problem.left.P = problem.right.P = 1 / (problem.gamma * mach * mach);
  }
  return problem;
}

bool is_double_blast(const TubeProblem& problem) {
  return std::string(problem.name) == "double-blast";
}

/// Tubes for strong waves, with particles of even spacing, so that their masses differ as the densities do.
class Tube final : public Scene {
 public:
  std::string name() const override { return "tube"; }
  std::string summary() const override {
    return "tubes for strong waves: blasts, near vacuum, cold streams, a slow shock";
  }

  void declare(Settings& settings) const override {
    std::vector<std::string> names;
    for (const TubeProblem& problem : problems) names.emplace_back(problem.name);
    declare_choice(settings, "scene.problem", "blast", list_of_problems(), names);
    declare_resolution(settings, 400, "particles per unit length");
    declare_dimension(settings, 1);
    declare_integer(settings, "scene.across", 8, "particles across the tube, in 2D and 3D", {.min = 1, .max = 10000});
    declare_real(settings, "scene.mach", 1e3, "Mach number of each of the streams", {.min = 1.01, .max = 1e8});
    adapt(settings);
  }
  void adapt(Settings& settings) const override {
    const auto& given = named(settings.text("scene.problem"));
    prefer_unless_set(settings, "sph.gamma", given.gamma);
    prefer_unless_set(settings, "time.end", given.end);
  }

  /// Walls are made by the tube's mirror image beside it, in a box that is periodic.
  ParticleSet build(const Settings& settings) const override {
    const TubeProblem problem = problem_of(settings);
    const int D = scene_dimension(settings), n = scene_n(settings);
    const double length = problem.upper - problem.lower;
    const Block block = bar(D, n, static_cast<int>(settings.integer("scene.across")), problem.lower, length);
    ParticleSet gas;
    gas.dimension = D;
    gas.box = {block.lower, block.size, {problem.walls, D > 1, D > 2}};
    if (problem.walls) gas.box.lower[0] -= length, gas.box.size[0] *= 2;
    const double volume = block.volume() / double(block.particles());
    for (Array3 x : lattice_points(block))
      for (const bool mirrored : {false, true}) {
        if (mirrored && !problem.walls) continue;
        const TubeState state = start(problem, x[0]);
        gas.x.push_back(x);
        if (mirrored) gas.x.back()[0] = 2 * problem.lower - x[0];
        gas.v.push_back({mirrored ? -state.v : state.v, 0, 0});
        gas.m.push_back(state.rho * volume);
        gas.u.push_back(GasState{.rho = state.rho, .P = state.P}.u(problem.gamma));
      }
    return gas;
  }

  /// As long as no wave has come back from a wall.
  ExactSolution exact(const Settings& settings) const override {
    const TubeProblem problem = problem_of(settings);
    if (is_double_blast(problem)) return {};
    const RiemannSolution solution(problem.left, problem.right, problem.gamma);
    return [problem, solution](const Array3& x, double t) -> GasState {
      const bool mirrored = problem.walls && x[0] < problem.lower;
      const double place = mirrored ? 2 * problem.lower - x[0] : x[0];
      const TubeState s = t > 0 ? solution.at((place - problem.jump) / t) : start(problem, place);
      return {s.rho, {mirrored ? -s.v : s.v, 0, 0}, s.P};
    };
  }
  Errors errors(const Settings& settings, const Snapshot& snapshot) const override {
    const auto solution = exact(settings);
    const PlotHint hint = plot_hint(settings);
    return solution ? profile_errors(snapshot, along_x(hint.from, hint.to), solution) : Errors{};
  }
  /// Without the free ends, which expand.
  PlotHint plot_hint(const Settings& settings) const override {
    const TubeProblem problem = problem_of(settings);
    const double margin = problem.walls ? 0 : 0.3 * (problem.upper - problem.lower);
    return {.abscissa = "x", .from = problem.lower + margin, .to = problem.upper - margin};
  }
  GalleryTile gallery() const override { return {.field = "v"}; }

 private:
  static TubeState start(const TubeProblem& problem, double x) {
    TubeState state = x < problem.jump ? problem.left : problem.right;
    if (is_double_blast(problem) && x > 0.9) state.P = 100;
    return state;
  }
};

}  // namespace

const Scene& tube_scene = Tube();

}  // namespace sphk
