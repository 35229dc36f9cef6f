// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "src/engine/errors.hpp"
#include "src/scenes/block.hpp"
#include "src/scenes/keys.hpp"
#include "src/scenes/norms.hpp"
#include "src/scenes/riemann.hpp"
#include "src/scenes/scenes.hpp"

namespace sphk {

namespace {

/// The variant of Valcke et al.
constexpr const char* valckes = "v10";

/// A shock tube and its particles: dense gas in [-1, 0), thin gas in [0, 1), periodic, so that a mirror image of the
/// jump stands at x = +-1.
struct Tube {
  TubeState left, right;
  Block left_block, right_block;
};

/// GridCounts of the thin side that keep the particle mass: spacings stretched alike on all axes, or along the tube
/// only (in 1D, and V10's lattice, its sec 3.1).
GridCounts thin_counts(const GridCounts& dense, int density_ratio, bool only_along) {
  if (only_along) return {dense[0] / density_ratio, dense[1], dense[2]};
  return {dense[0] / 2, dense[1] / 2, std::max(dense[2] / 2, 1)};  // 2^D = the ratio: 8 in 3D, 4 in 2D
}

Tube tube_of(const Settings& settings) {
  const std::string& variant = settings.text("scene.variant");
  const bool v10 = variant == valckes;
  const int D = scene_dimension(settings), own_dimension = v10 ? 2 : 3;
  if (D != 1 && D != own_dimension)
    throw InputError(fmt::format("scene.dimension = {}: the tube \"{}\" is made for {} dimensions, or 1", D, variant,
                                 own_dimension));
  const int n = scene_n(settings), across = static_cast<int>(settings.integer("scene.across"));
  const int ratio = v10 ? 4 : 8;
  const bool only_along = D == 1 || (v10 && settings.text("scene.lattice") == "cubic");
  const bool equal = has_equal_masses(settings);
  const int step = !equal ? 1 : only_along ? ratio : 2;
  if (n % step != 0) throw InputError(fmt::format("scene.n = {}: this tube needs a multiple of {}", n, step));
  if (equal && across % 2 != 0)
    throw InputError(fmt::format("scene.across = {}: this tube needs an even number", across));

  Tube tube{.left = {1, 0, 1}, .right = {0.125, 0, 0.1}, .left_block = {}, .right_block = {}};
  if (v10) tube.right = {0.25, 0, 1.0 / 6};  // u = 1 with gamma 5/3
  tube.left_block = bar(D, n, across, -1, 1);
  tube.right_block = tube.left_block;
  tube.right_block.lower[0] = 0;
  if (equal) tube.right_block.counts = thin_counts(tube.left_block.counts, ratio, only_along);
  return tube;
}

/// S12 sec 7.2: the test starts with a shock, so alpha = 1 around the jump, and around its mirror image at the ends.
void switch_on_at_the_jumps(ParticleSet& gas) {
  for (const Array3& x : gas.x) gas.alpha.push_back(std::abs(x[0]) < 0.05 || std::abs(x[0]) > 0.95 ? 1 : 0);
}

/// V10 sec 3.1: rows of equal spacing across, 400 dense particles over 3/4 along; its scheme and kernel.
void prefer_as_v10(Settings& settings) {
  prefer_unless_set(settings, "scene.n", std::int64_t{528});
  prefer_unless_set(settings, "scene.across", std::int64_t{52});
  prefer_unless_set(settings, "scene.lattice", "cubic");
  prefer_unless_set(settings, "sph.scheme", "v10");
  prefer_unless_set(settings, "sph.kernel", "liq");
  prefer_unless_set(settings, "sph.neighbours", 32.0);
}

class Sod : public Scene {
 public:
  /// `masses`: the standard value of scene.masses.
  Sod(std::string name, std::string summary, std::string masses)
      : name_(std::move(name)), summary_(std::move(summary)), masses_(std::move(masses)) {}
  std::string name() const override { return name_; }
  std::string summary() const override { return summary_; }

  void declare(Settings& settings) const override {
    declare_choice(settings, "scene.variant", "s12",
                   "states: s12 (gamma 5/3), r10 (gamma 1.4), v10 (2D, density ratio 4)", {"s12", "r10", "v10"});
    declare_resolution(settings, 64, "dense particles per unit length (S12's N1D is 3/4 of it)");
    declare_integer(settings, "scene.across", 32, "dense particles across the tube", {.min = 2, .max = 10000});
    declare_dimension(settings, 3);
    declare_arrangement(settings, "glass");
    declare_masses(settings, masses_);
    if (masses_ == "multi") prefer_unless_set(settings, "sph.scheme", "sphs");
    prefer_unless_set(settings, "time.end", 0.2);
    adapt(settings);
  }
  void adapt(Settings& settings) const override {
    const std::string& variant = settings.text("scene.variant");
    prefer_unless_set(settings, "scene.dimension", std::int64_t{variant == valckes ? 2 : 3});
    prefer_unless_set(settings, "sph.gamma", variant == "r10" ? 1.4 : 5.0 / 3);
    if (variant == valckes) prefer_as_v10(settings);
  }

  ParticleSet build(const Settings& settings) const override {
    const Tube tube = tube_of(settings);
    const auto start = exact(settings);
    const std::string& lattice = settings.text("scene.lattice");
    ParticleSet gas = even_gas(tube.left_block, lattice);
    gas.box.size[0] = 2;
    add_block(gas, tube.right_block, lattice, tube.right.rho);
    for (const Array3& x : gas.x) gas.u.push_back(start(x, 0).u(settings.real("sph.gamma")));
    switch_on_at_the_jumps(gas);
    return gas;
  }

  /// Valid until the waves of the jump and of its mirror image meet, about t = 0.27.
  ExactSolution exact(const Settings& settings) const override {
    const Tube tube = tube_of(settings);
    const RiemannSolution solution(tube.left, tube.right, settings.real("sph.gamma"));
    return [tube, solution](const Array3& x, double t) -> GasState {
      const bool mirrored = std::abs(x[0]) > 0.5;
      const double distance = mirrored ? std::copysign(1, x[0]) - x[0] : x[0];
      const TubeState state = t > 0 ? solution.at(distance / t) : distance < 0 ? tube.left : tube.right;
      return {state.rho, {mirrored ? -state.v : state.v, 0, 0}, state.P};
    };
  }
  Errors errors(const Settings& settings, const Snapshot& snapshot) const override {
    return profile_errors(snapshot, along_x(-0.5, 0.5), exact(settings));
  }
  std::vector<PaperChoice> paper(const Settings& settings) const override {
    const std::string& variant = settings.text("scene.variant");
    std::vector<PaperChoice> choices{
        {"all: one tube; here its mirror image follows, which waves reach after t = 0.27"}};
    const auto add = [&](PaperChoice choice) { choices.push_back(std::move(choice)); };
    if (variant == valckes) {
      add({"V10: the dense gas on 50 columns 0.002 apart, 400 particles on 0.75 of each; here both are 1/528 apart"});
      add({"V10: steps of the particles' own", {"time.steps=individual"}});
    } else if (variant == "r10") {
      add({"R10: lattices of 24 x 24 x 300 and 12 x 12 x 150",
           {"scene.n=600", "scene.across=24", "scene.lattice=cubic"}});
      add({"R10: OSPH, and SPH, with 442 neighbours, energies and steps of the particles' own",
           {"sph.scheme=OSPH-HOCT4-442", "time.steps=individual"}});
    } else if (has_equal_masses(settings)) {
      add({"S12: lattices of 32 x 32 x 400 and 16 x 16 x 200 (N1D = 600)",
           {"scene.n=800", "scene.across=32", "scene.lattice=cubic"}});
      add({"S12: SPHS, and SPH with 96 neighbours", {"sph.scheme=SPHS-HCT442"}});
    } else {
      add({"S12: a lattice of 16 x 16 x 400", {"scene.n=400", "scene.across=16", "scene.lattice=cubic"}});
      add({"S12: SPHS", {"sph.scheme=SPHS-HCT442"}});
    }
    return choices;
  }
  PlotHint plot_hint(const Settings&) const override { return {.abscissa = "x", .from = -0.5, .to = 0.5}; }
  GalleryTile gallery() const override {
    if (masses_ == "equal") return {};
    return {.keys = {"scene.n=32", "scene.across=16"}};
  }

 private:
  std::string name_, summary_, masses_;
};

}  // namespace

const Scene& sod_scene = Sod("sod", "shock tube of S12, R10 or V10 against the exact solution", "equal");
const Scene& sod_multimass_scene =
    Sod("sod-multimass", "the tube evenly sampled by masses of ratio 8 (S12 sec 7.2)", "multi");

}  // namespace sphk
