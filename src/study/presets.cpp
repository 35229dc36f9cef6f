#include "src/study/presets.hpp"

namespace sphk {

namespace {

using Keys = std::vector<std::pair<std::string, std::string>>;

Keys method(const std::string& scheme, const std::string& kernel, const std::string& neighbours, Keys others = {}) {
  Keys keys{{"sph.scheme", scheme}, {"sph.kernel", kernel}, {"sph.neighbours", neighbours}};
  keys.insert(keys.end(), others.begin(), others.end());
  return keys;
}

/// Every method at every resolution.
std::vector<StudyPoint> at(const std::vector<std::string>& resolutions, const std::vector<Keys>& methods) {
  std::vector<StudyPoint> points;
  for (const Keys& keys : methods)
    for (const std::string& n : resolutions) {
      StudyPoint point{keys};
      point.keys.emplace_back(resolution_key, n);
      points.push_back(point);
    }
  return points;
}

/// S12's default with one number changed at a time.
std::vector<Keys> changed(const std::vector<std::pair<std::string, std::string>>& changes) {
  std::vector<Keys> methods{method("sphs", "hoct4", "442")};
  for (const auto& change : changes) methods.push_back(method("sphs", "hoct4", "442", {change}));
  return methods;
}

}  // namespace

const std::vector<StudyPreset>& study_presets() {
  static const std::vector<StudyPreset> presets{
      {"sod-convergence",
       "Sod's tube, classic against SPHS (S12 Fig. 4: error falls with n^-0.9)",
       "sod",
       "v",
       0.037,
       at({"32", "64", "128"}, {method("gadget2", "cs", "42"), method("sphs", "hoct4", "442")}),
       {{"scene.across", "16"}}},
      {"gresho-convergence", "Gresho's vortex, CS42, HCT442 and HCT442e (S12 Fig. 6: n^-1.4)", "gresho", "v", 0.071,
       at({"16", "32", "64"},
          {method("gadget2", "cs", "42"), method("sphs", "hoct4", "442"), method("sphs-morris", "hoct4", "442")})},
      {"dissipation-scan", "strengths of the dissipation of SPHS on the vortex (S12 App. C)", "gresho", "v", 0,
       at({"32"}, changed({{"viscosity.alpha", "0.1"},
                           {"viscosity.alpha", "5"},
                           {"dissipation.entropy", "0.1"},
                           {"dissipation.entropy", "5"},
                           {"switch.alpha_min", "0"}}))},
      {"ablation",
       "SPHS with one part switched off on the tube (S12 App. F)",
       "sod",
       "v",
       0,
       at({"64"}, changed({{"dissipation.entropy", "0"},
                           {"viscosity.alpha", "0"},
                           {"switch.alpha", "1"},
                           {"time.steps", "global"},
                           {"sph.energy", "energy"}})),
       {{"scene.across", "16"}}},
      {"neighbour-scan", "TSPH with CT and more and more neighbours on the vortex (R10 App. A)", "gresho", "v", 0,
       at({"32"}, {method("tsph", "ct", "32"), method("tsph", "ct", "64"), method("tsph", "ct", "128"),
                   method("tsph", "hoct4", "442")})},
      {"kernel-choice", "stable kernels with about 100 neighbours against HOCT4 with 442, on the vortex", "gresho", "v",
       0.071,
       at({"32", "64"}, {method("sphs", "hoct4", "96"), method("sphs", "m5", "96"), method("sphs", "wc2", "100"),
                         method("sphs", "liq", "80"), method("sphs", "hoct4", "442")})}};
  return presets;
}

}  // namespace sphk
