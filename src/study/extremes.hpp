#pragma once

#include <string>
#include <utility>
#include <vector>

namespace sphk {

/// A number that a run has to keep below a bound: "energy" and "momentum" (relative drifts), "l1_v" and the like (error
/// norms), "front" (distance of the foremost shock from its place, in support radii ahead), or a measure of the scene.
struct Requirement {
  std::string quantity;
  double bound = 0;
};

/// A stiff or extreme run. Beside its own requirements it has to finish, and all its numbers have to be finite, with
/// positive densities, energies and entropies.
struct ExtremeCase {
  std::string name;
  std::string setup;  ///< a few words
  std::string scene;
  std::vector<std::pair<std::string, std::string>> keys;
  std::vector<Requirement> requirements;
};

const std::vector<ExtremeCase>& extreme_cases();

}  // namespace sphk
