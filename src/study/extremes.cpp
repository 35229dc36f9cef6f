#include "src/study/extremes.hpp"

namespace sphk {

namespace {

using Keys = std::vector<std::pair<std::string, std::string>>;
using Requirements = std::vector<Requirement>;

template <class T>
std::vector<T> operator+(std::vector<T> some, const std::vector<T>& more) {
  some.insert(some.end(), more.begin(), more.end());
  return some;
}

Keys set(const char* key, const char* value) {
  return {{key, value}};
}

const Keys gadget2 = set("sph.scheme", "gadget2");  // of equal masses, where it conserves energy
const Keys energies = set("sph.energy", "energy");  // conserves it with any masses
const Keys even_pressures = set("sph.scheme", "osph-coherent") + energies;  // even pressures where densities jump
const Keys wendland = set("sph.kernel", "wc4") + set("sph.neighbours", "200");

Keys tube(const char* problem) {
  return set("scene.problem", problem);
}
Keys dimension(const char* D) {
  return set("scene.dimension", D);
}
Keys n(const char* particles) {
  return set("scene.n", particles);
}

Requirement at_least(const char* quantity, double above) {
  Requirement requirement{quantity};
  requirement.above = above;
  return requirement;
}

std::vector<ExtremeCase> shocks() {
  const Requirements conserved{{"energy", 1e-3}, {"momentum", 1e-6}}, in_place{{"front", 2}};
  const auto streams = [](const char* mach) { return tube("streams") + gadget2 + set("scene.mach", mach); };
  return {
      {"blast", "P 1000 beside 0.01", "tube", tube("blast") + gadget2, conserved + in_place},
      {"strong-blast", "P 3000 beside 1e-7", "tube", tube("strong-blast") + gadget2, conserved + in_place},
      {"double-blast", "Woodward & Colella", "tube", tube("double-blast") + gadget2, conserved},
      {"leblanc",
       "density 1:1000, P 1:1e9",
       "tube",
       tube("leblanc") + energies,
       {{"energy", 1e-2}, {"front", 2}, {"l1_v", 0.02}}},
      {"slow-shock",
       "a shock of speed 0.11",
       "tube",
       tube("slow-shock") + energies,
       {{"energy", 1e-3}, {"l1_rho", 0.14}}},  // 5 % of the jump
      {"streams-3", "streams of Mach 1e3", "tube", streams("1e3"), {{"energy", 1e-3}, {"front", 2}, {"l1_v", 0.02}}},
      {"streams-5", "streams of Mach 1e5", "tube", streams("1e5"), {{"energy", 1e-3}, {"front", 2}, {"l1_v", 0.02}}},
      {"streams-5-2d",
       "streams of Mach 1e5 in 2D",
       "tube",
       streams("1e5") + dimension("2") + n("100"),
       {{"energy", 1e-3}, {"front", 2}, {"l1_v", 0.05}}},
      {"streams-5-3d",
       "streams of Mach 1e5 in 3D",
       "tube",
       streams("1e5") + dimension("3") + n("64"),
       {{"energy", 1e-3}, {"front", 2}, {"l1_v", 0.1}}},
      // The best of the six methods of Spheral (Noh-planar-1d.py): GSPH for the density, CRKSPH for the velocity.
      {"noh-1d",
       "100 points; the best of six",
       "noh",
       gadget2 + dimension("1") + n("100") + set("sph.neighbours", "4") + set("viscosity.alpha", "0.75") +
           set("viscosity.beta", "1.5"),
       {{"energy", 1e-3}, {"line_error_rho", 0.0484}, {"line_error_v", 0.00775}, {"wall_heating"}}},
      {"noh-2d",
       "50 across the radius",
       "noh",
       set("sph.scheme", "osph") + energies + dimension("2") + n("50"),
       {{"energy", 1e-3}, {"scatter", 0.05}, {"wall_heating"}}},
      {"noh-3d",
       "20 across the radius",
       "noh",
       set("sph.scheme", "sphs") + energies + dimension("3") + n("20"),
       {{"energy", 1e-3}, {"scatter", 0.05}, {"wall_heating"}}},
  };
}

std::vector<ExtremeCase> vacuum() {
  const auto ball = [](const char* name, const char* setup, const char* D, const char* particles) {
    return ExtremeCase{name,
                       setup,
                       "expansion",
                       gadget2 + dimension(D) + n(particles),
                       {{"energy", 1e-3}, {"density_error", 0.1}, {"l1_v", 0.1}}};
  };
  return {
      {"rarefactions",
       "1-2-0-3, near vacuum",
       "tube",
       tube("rarefactions"),
       {{"energy", 1e-3}, {"l1_rho", 0.01}, {"l1_v", 0.02}}},
      ball("expansion-1d", "a ball into vacuum, 1D", "1", "200"),
      ball("expansion-2d", "a ball into vacuum, 2D", "2", "32"),
      ball("expansion-3d", "a ball into vacuum, 3D", "3", "16"),
  };
}

std::vector<ExtremeCase> explosions() {
  const Requirements required{{"energy", 1e-2}, {"momentum", 1e-6}, {"roundness", 0.05}};
  return {
      {"point-explosion", "all energy in one particle, 16^3", "point-explosion", n("16"), required},
      {"point-explosion-15", "the same in fifteen", "point-explosion", n("16") + set("scene.hot", "15"), required},
      {"point-explosion-late", "the same in mid-run", "point-explosion",
       n("16") + set("scene.delay", "0.03") + set("time.end", "0.08"), required},
      {"point-explosion-32", "one particle of 32^3", "point-explosion", n("32"), required},
      {"point-explosion-32-15", "fifteen particles of 32^3", "point-explosion", n("32") + set("scene.hot", "15"),
       required},
      {"sedov-mass-jump",
       "a blast into masses 64 times as large",
       "sedov",
       gadget2 + n("32") + set("scene.coarser", "4"),
       {{"energy", 0.01}, {"momentum", 1e-3}, {"roundness", 0.05}}},
  };
}

/// Gas in pressure balance that nothing should happen to.
std::vector<ExtremeCase> at_rest() {
  std::vector<ExtremeCase> cases;
  // Gas of unlike masses settles until its pressure stays even.
  const auto jump = [&](const char* name, const char* setup, const char* finer, const char* boost) {
    cases.push_back({name,
                     setup,
                     "square",
                     gadget2 + wendland + dimension("3") + n("8") + set("scene.ratio", "1") +
                         set("scene.finer", finer) + set("scene.boost", boost) + set("time.end", "0.5") +
                         set("ic.pressure", "2.5") + set("ic.relax", "4") + set("ic.rounds", "40"),
                     {{"energy", 1e-2}, {"momentum", 1e-6}, {"pressure_error", 0.05}, {"drift", 0.01}}});
  };
  jump("mass-jump-8", "masses 1:8 at rest", "2", "0");
  jump("mass-jump-27", "masses 1:27 at rest", "3", "0");
  jump("mass-jump-64", "masses 1:64 at rest", "4", "0");
  jump("mass-jump-8-boosted", "masses 1:8 at 100 c", "2", "204");  // c = 2.04 along x and y
  jump("mass-jump-27-boosted", "masses 1:27 at 100 c", "3", "204");
  jump("mass-jump-64-boosted", "masses 1:64 at 100 c", "4", "204");
  const auto contrast = [&](const char* name, const char* setup, const char* ratio, const char* shear) {
    cases.push_back(
        {name,
         setup,
         "square",
         even_pressures + set("scene.shape", "layer") + set("scene.ratio", ratio) + set("scene.shear", shear),
         {{"energy", 1e-2}, {"gap", 1}, {"pairs", 2}, {"drift", 0.01}, {"pressure_error", 0.05}}});
  };
  contrast("contrast-3", "density 1:1000 at rest", "1e3", "0");
  contrast("contrast-6", "density 1:1e6 at rest", "1e6", "0");
  contrast("contrast-3-sheared", "density 1:1000 in shear", "1e3", "1");
  contrast("contrast-6-sheared", "density 1:1e6 in shear", "1e6", "1");
  const auto square = [&](const char* name, const char* setup, const char* boost) {
    cases.push_back({name,
                     setup,
                     "square",
                     set("scene.temperatures", "smoothed") + set("scene.boost", boost),
                     {{"energy", 1e-2}, {"momentum", 1e-3}, {"pressure_error", 0.2}, {"drift", 0.01}}});
  };
  square("square", "density 1:4 keeps its shape", "0");
  square("square-boosted", "the same at 142", "142");
  cases.push_back({"boost",
                   "an even box at a million times c",
                   "square",
                   set("scene.ratio", "1") + set("scene.boost", "1.4e6") + set("time.end", "1e-4"),
                   {{"pressure_error", 1e-2}, {"mach", 1e-2}}});
  return cases;
}

std::vector<ExtremeCase> rotation() {
  const Keys vortex = set("scene.layers", "8") + set("scene.lattice", "glass") + set("sph.scheme", "sphs-morris") +
                      set("time.courant", "0.4");
  return {
      {"gresho-3",
       "a vortex to t = 3",
       "gresho",
       vortex + n("48") + set("time.end", "3"),
       {{"energy", 1e-2}, {"l1_v", 0.1}}},
      {"gresho-boosted",
       "a vortex that moves at 3",
       "gresho",
       vortex + n("32") + set("scene.boost", "3"),
       {{"energy", 1e-2}, {"l1_v", 0.1}}},
      {"ring",
       "five orbits of a cold ring",
       "ring",
       {},
       {{"energy", 2e-2}, {"angular_momentum", 1e-2}, {"ring_width", 1.25}, {"l1_v", 0.02}}},
  };
}

/// Arrangements of particles. A lattice keeps where `sphk stability` finds no growing wave, and breaks where it does.
std::vector<ExtremeCase> arrangements() {
  const auto lattice = [](const char* kernel, const char* neighbours) {
    return gadget2 + n("16") + set("scene.lattice", "cubic") + set("scene.jitter", "0.01") + set("sph.kernel", kernel) +
           set("sph.neighbours", neighbours) + set("time.end", "1");
  };
  return {
      {"settling",
       "random places settle",
       "uniform",
       gadget2 + wendland + n("16") + set("scene.lattice", "random") + set("time.end", "2"),
       {{"energy", 1e-2}, {"density_scatter", 0.05}, at_least("nearest", 0.7)}},
      {"lattice-kept", "HOCT4 with 442", "uniform", lattice("hoct4", "442"), {at_least("nearest", 0.95)}},
      {"lattice-broken", "CS with 128", "uniform", lattice("cs", "128"), {{"nearest", 0.9}}},
  };
}

}  // namespace

const std::vector<ExtremeCase>& extreme_cases() {
  static const std::vector<ExtremeCase> cases = [] {
    std::vector<ExtremeCase> all;
    for (auto part : {shocks, vacuum, explosions, at_rest, rotation, arrangements})
      for (ExtremeCase& one : part()) all.push_back(std::move(one));
    return all;
  }();
  return cases;
}

}  // namespace sphk
