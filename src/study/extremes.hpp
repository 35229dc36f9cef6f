#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace sphk {

/// A number of a run and what it has to be: "energy", "momentum" and "angular_momentum" (relative drifts), "l1_v" and
/// the like (error norms), "front" (distance of the foremost shock from its place, in support radii ahead), "pairs" (of
/// an update, over the neighbour number), or a measure of the scene.
struct Requirement {
  std::string quantity;
  double below = std::numeric_limits<double>::infinity();
  double above = -std::numeric_limits<double>::infinity();  ///< with neither it is recorded
};

/// A stiff or extreme run. Beside its own requirements it has to finish, all its numbers have to be finite, with
/// positive densities, energies and entropies, and one thread and two have to agree.
struct ExtremeCase {
  std::string name;
  std::string setup;  ///< a few words
  std::string scene;
  std::vector<std::pair<std::string, std::string>> keys;
  std::vector<Requirement> requirements;
};

const std::vector<ExtremeCase>& extreme_cases();

}  // namespace sphk
