#include "src/study/extremes.hpp"

namespace sphk {

const std::vector<ExtremeCase>& extreme_cases() {
  using Keys = std::vector<std::pair<std::string, std::string>>;
  const auto tube = [](const char* problem, Keys keys = {}) {
    keys.emplace_back("scene.problem", problem);
    return keys;
  };
  const Keys gadget2{{"sph.scheme", "gadget2"}};  // of equal masses, where it conserves energy
  const Keys energies{{"sph.energy", "energy"}};  // conserves it with any masses
  static const std::vector<ExtremeCase> cases{
      {"blast",
       "P 1000 beside 0.01",
       "tube",
       tube("blast", gadget2),
       {{"energy", 1e-3}, {"momentum", 1e-6}, {"front", 2}}},
      {"strong-blast",
       "P 3000 beside 1e-7",
       "tube",
       tube("strong-blast", gadget2),
       {{"energy", 1e-3}, {"momentum", 1e-6}, {"front", 2}}},
      {"double-blast",
       "Woodward & Colella",
       "tube",
       tube("double-blast", gadget2),
       {{"energy", 1e-3}, {"momentum", 1e-6}}},
      {"rarefactions",
       "1-2-0-3, near vacuum",
       "tube",
       tube("rarefactions"),
       {{"energy", 1e-3}, {"l1_rho", 0.01}, {"l1_v", 0.02}}},
      {"leblanc",
       "density 1:1000, P 1:1e9",
       "tube",
       tube("leblanc", energies),
       {{"energy", 1e-2}, {"front", 2}, {"l1_v", 0.02}}},
      {"slow-shock",
       "a shock of speed 0.11",
       "tube",
       tube("slow-shock", energies),
       {{"energy", 1e-3}, {"l1_rho", 0.14}}},  // 5 % of the jump
      {"streams-3",
       "streams of Mach 1e3",
       "tube",
       tube("streams", {gadget2[0], {"scene.mach", "1e3"}}),
       {{"energy", 1e-3}, {"front", 2}, {"l1_v", 0.02}}},
      {"streams-5",
       "streams of Mach 1e5",
       "tube",
       tube("streams", {gadget2[0], {"scene.mach", "1e5"}}),
       {{"energy", 1e-3}, {"front", 2}, {"l1_v", 0.02}}},
      {"noh-1d",
       "100 points; the best of six",
       "noh",
       {{"scene.dimension", "1"}, {"scene.n", "100"}, {"sph.scheme", "osph"}, energies[0]},
       {{"energy", 1e-3}, {"l1_rho", 0.0484}, {"l1_v", 0.00775}}},
      {"noh-2d",
       "50 across the radius",
       "noh",
       {{"scene.dimension", "2"}, {"scene.n", "50"}, {"sph.scheme", "osph"}, energies[0]},
       {{"energy", 1e-3}, {"l1_v", 0.05}}},
      {"point-explosion",
       "all energy in one particle",
       "point-explosion",
       {{"scene.n", "16"}},
       {{"energy", 1e-2}, {"momentum", 1e-6}}},
      {"boost",
       "an even box at a million times c",
       "square",
       {{"scene.ratio", "1"}, {"scene.boost", "1.4e6"}, {"time.end", "1e-4"}},
       {{"pressure_error", 1e-2}, {"mach", 1e-2}}},
      {"mass-jump",
       "masses 1:8 at rest",
       "square",
       {{"scene.ratio", "8"}, {"scene.temperatures", "smoothed"}},
       {{"energy", 1e-2}, {"momentum", 1e-6}, {"pressure_error", 0.05}, {"mach", 0.05}}},
      {"mass-jump-boosted",
       "masses 1:8 at a hundred times c",
       "square",
       {{"scene.ratio", "8"}, {"scene.temperatures", "smoothed"}, {"scene.boost", "100"}},
       {{"momentum", 1e-6}, {"pressure_error", 0.05}, {"mach", 0.05}}},
  };
  return cases;
}

}  // namespace sphk
