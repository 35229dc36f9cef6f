// SPDX-License-Identifier: BSD-3-Clause
#include "src/study/gallery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "src/report/machine.hpp"
#include "src/report/plot_script.hpp"
#include "src/report/print.hpp"
#include "src/report/quantity.hpp"
#include "src/run/failure.hpp"
#include "src/run/plot_items.hpp"
#include "src/run/stop_signal.hpp"
#include "src/scenes/scene.hpp"
#include "src/study/child.hpp"
#include "src/study/study_record.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

/// A scene, its tile and what its run came to.
struct GalleryRun {
  const Scene* scene;
  GalleryTile tile;
  fs::path folder;
  std::string failure{};               ///< empty: there is a run
  std::array<std::string, 2> lines{};  ///< what ran; its error and cost

  std::string words() const { return failure.empty() ? lines[0] + ", " + lines[1] : "failed: " + failure; }
  fs::path thumbnail() const { return folder / "thumbnail.png"; }
};

KeyTexts keys_of_tile(const GalleryRun& shown) {
  KeyTexts keys{{"output.snapshots", "1"}};
  for (const std::string& text : shown.tile.keys) {
    const std::size_t sign = text.find('=');
    keys.emplace_back(text.substr(0, sign), text.substr(sign + 1));
  }
  return keys;
}

/// "L1(rho) 0.021" of what the tile shows, or how far a measure is from converged runs, or the drift of the energy
/// where nothing is known.
std::string error_of(const Json& run, const GalleryTile& tile) {
  for (const std::string& field : {tile.field.value_or("rho"), std::string("rho")})
    if (run["errors"].contains(field))
      return fmt::format("L1({}) {:.2g}", field, number_in(run["errors"][field]["l1"]));
  for (const auto& [measure, deviation] : run["deviations"].items())
    return fmt::format("{} off by {:.2g} %", measure == "cloud_mass" ? "cloud's mass" : measure,
                       100 * number_in(deviation["l1"]));
  return fmt::format("energy drift {:.0e}", number_in(run["conservation"]["energy"]));
}

GalleryRun show(const Scene& scene, const fs::path& gallery, int threads) {
  GalleryRun shown{&scene, scene.gallery(), gallery / "runs" / scene.name()};
  fs::create_directories(shown.folder.parent_path());
  const fs::path log = shown.folder.string() + ".log";
  const int code = run_child(run_arguments(scene.name(), keys_of_tile(shown), shown.folder, threads), log);
  if (code != ExitCode::done) {
    shown.failure = reason_of(code, log);
    return shown;
  }
  const Json run = read_json(shown.folder / "run.json");
  shown.lines = {
      fmt::format("{} {} {:g}, {} particles", run["scheme"].get<std::string>(), run["kernel"].get<std::string>(),
                  run["neighbours"].get<double>(), with_prefix(run["particles"])),
      error_of(run, shown.tile) + " in " + duration_text(run["cpu_seconds"])};
  return shown;
}

/// Draws the thumbnails and the sheet with all of them.
void draw(const std::vector<GalleryRun>& tiles, const fs::path& sheet) {
  Json items = Json::array();
  NumberFiles files;
  for (const GalleryRun& shown : tiles) {
    if (!shown.failure.empty()) continue;
    const std::optional<Problem> problem = resolve_problem((shown.folder / "scene.used.toml").string(), {});
    PlotItem item(shown.folder / "snap_0001.hdf5", problem, files);
    const std::string field = shown.tile.field.value_or(item.prefers_map() ? "" : "rho");
    if (field.empty()) item.add_map("rho", {.pixels = 320});
    if (!field.empty()) item.add_along({field});
    item.add_exact(*problem);
    item.json["field"] = field;
    item.json["heading"] = shown.scene->name();
    item.json["words"] = shown.lines;
    item.json["out"] = shown.thumbnail().string();
    items.push_back(item.json);
  }
  if (!items.empty()) run_plot_script(Json{{"gallery", items}, {"out", sheet.string()}}.dump());
}

void write_page(const std::vector<GalleryRun>& runs, const fs::path& page) {
  Json tiles = Json::array();
  for (const GalleryRun& shown : runs) {
    std::string command = "sphk run " + shown.scene->name();
    for (const auto& [key, value] : keys_of_tile(shown)) command += fmt::format(" --set {}={}", key, value);
    tiles.push_back({{"file", shown.failure.empty() ? shown.thumbnail().string() : ""},
                     {"name", shown.scene->name()},
                     {"summary", shown.scene->summary()},
                     {"words", shown.words()},
                     {"command", command}});
  }
  run_plot_script(Json{{"page", "gallery.html"},
                       {"out", page.string()},
                       {"title", "sphk: the gallery"},
                       {"machine", machine_name()},
                       {"tiles", tiles}}
                      .dump(),
                  packages_of_pages);
}

}  // namespace

bool make_gallery(const Batch& batch) {
  for (const std::string& name : batch.names) find_scene(name);
  std::vector<const Scene*> wanted = scenes();
  std::erase_if(wanted, [&](const Scene* scene) { return !batch.wants(scene->name()); });
  run_plot_script("{}", packages_of_pages);  // before minutes of runs
  const fs::path folder = batch.out.value_or("gallery");
  fs::create_directories(folder);
  catch_stop_signals();
  std::vector<GalleryRun> tiles;
  for (const Scene* scene : wanted) {
    say("[{}/{}] {} ...", tiles.size() + 1, wanted.size(), scene->name());
    tiles.push_back(show(*scene, folder, batch.threads));
    if (stop_requested()) {
      say(" stopped\n");
      return false;
    }
    say(" {}\n", tiles.back().words());
  }
  draw(tiles, folder / "gallery.png");
  write_page(tiles, folder / "index.html");
  return std::ranges::all_of(tiles, [](const GalleryRun& shown) { return shown.failure.empty(); });
}

}  // namespace sphk
