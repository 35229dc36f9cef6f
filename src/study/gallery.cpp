#include "src/study/gallery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "src/io/atomic_file.hpp"
#include "src/report/html.hpp"
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
  for (const GalleryRun& shown : tiles) {
    if (!shown.failure.empty()) continue;
    Json item = describe_snapshot(shown.folder / "snap_0001.hdf5",
                                  resolve_problem((shown.folder / "scene.used.toml").string(), {}), true);
    item["field"] = shown.tile.field.value_or(item["map"].get<bool>() ? "" : "rho");
    item["heading"] = shown.scene->name();
    item["words"] = shown.lines;
    item["out"] = shown.thumbnail().string();
    items.push_back(item);
  }
  if (!items.empty()) run_plot_script(Json{{"gallery", items}, {"out", sheet.string()}}.dump());
}

std::string page_of(const std::vector<GalleryRun>& tiles) {
  std::string body = fmt::format(
      "<h1>sphk: the gallery</h1>\n<p class=\"meta\">A small run of every scene, in CPU seconds of the time loop on "
      "{}. "
      "Points are particles or their means, lines the exact solution.</p>\n<div class=\"tiles\">\n",
      html_text(machine_name()));
  for (const GalleryRun& shown : tiles) {
    const bool there = shown.failure.empty();
    const std::string name = shown.scene->name();
    std::string command = "sphk run " + name;
    for (const auto& [key, value] : keys_of_tile(shown)) command += fmt::format(" --set {}={}", key, value);
    body += fmt::format(
        "<figure>{}<figcaption><b>{}</b>: {}<br>{}<br><details><summary>command</summary><code>{}</code></details>"
        "</figcaption></figure>\n",
        there ? html_image(shown.thumbnail(), name) : "", html_text(name), html_text(shown.scene->summary()),
        html_text(shown.words()), html_text(command));
  }
  return html_page("sphk: the gallery", body + "</div>\n");
}

}  // namespace

bool make_gallery(const Batch& batch) {
  for (const std::string& name : batch.names) find_scene(name);
  std::vector<const Scene*> wanted = scenes();
  std::erase_if(wanted, [&](const Scene* scene) { return !batch.wants(scene->name()); });
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
  write_atomically(folder / "index.html", page_of(tiles));
  say("{}\n", (folder / "index.html").string());
  return std::ranges::all_of(tiles, [](const GalleryRun& shown) { return shown.failure.empty(); });
}

}  // namespace sphk
