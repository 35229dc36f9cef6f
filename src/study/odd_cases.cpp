#include "src/study/odd_cases.hpp"

namespace sphk {

namespace {

/// gadget2 conserves. Its forces are opposite for pairs that step together; else its momentum, as its energy, drifts by
/// the error of the time integration, which is largest where gas on a plane or line expands. sphs has only to go on.
OddArrangement arrangement(const std::string& problem, const std::string& setup) {
  OddArrangement odd{"odd-" + problem, setup, {}};
  for (const std::string scheme : {"gadget2", "sphs"})
    for (const std::string steps : {"global", "individual"}) {
      odd.cases.push_back({odd.name + "-" + scheme + "-" + steps,
                           setup,
                           "odd",
                           {{"scene.problem", problem}, {"sph.scheme", scheme}, {"time.steps", steps}},
                           {}});
      if (scheme == "gadget2")
        odd.cases.back().requirements = {{"energy", 1e-2}, {"momentum", steps == "global" ? 1e-6 : 1e-3}};
    }
  return odd;
}

}  // namespace

const std::vector<OddArrangement>& odd_arrangements() {
  static const std::vector<OddArrangement> all{arrangement("pair", "two particles at one place"),
                                               arrangement("ten", "ten particles at one place"),
                                               arrangement("plane", "a box collapsed onto a plane"),
                                               arrangement("one", "one particle"),
                                               arrangement("two", "two, a million boxes apart"),
                                               arrangement("ejected", "one leaves at 1e3 times c"),
                                               arrangement("line", "all on a line")};
  return all;
}

}  // namespace sphk
