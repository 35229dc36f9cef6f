#include "src/study/gallery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "src/io/atomic_file.hpp"
#include "src/report/html.hpp"
#include "src/report/machine.hpp"
#include "src/report/plot_script.hpp"
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
struct Shown {
  const Scene* scene;
  GalleryTile tile;
  fs::path folder;
  std::string failure;  ///< empty: there is a run
  Json run;
};

std::vector<std::string> arguments_of(const Shown& shown) {
  std::vector<std::string> words{shown.scene->name(), "--set", "output.snapshots=1"};
  for (const std::string& key : shown.tile.keys) words.insert(words.end(), {"--set", key});
  return words;
}

Shown show(const Scene& scene, const fs::path& gallery, int threads) {
  Shown shown{&scene, scene.gallery(), gallery / "runs" / scene.name(), "", {}};
  fs::create_directories(shown.folder.parent_path());
  const fs::path log = shown.folder.string() + ".log";
  std::vector<std::string> words = arguments_of(shown);
  words.insert(words.end(), {"--out", shown.folder.string(), "--overwrite"});
  if (threads > 0) words.insert(words.end(), {"--threads", std::to_string(threads)});
  const int code = run_child(words, log);
  if (code == ExitCode::done)
    shown.run = read_json(shown.folder / "run.json");
  else
    shown.failure = reason_of(code, log);
  return shown;
}

/// "L1(rho) 0.021" of what the tile shows, or how far a measure is from converged runs, or the drift of the energy
/// where nothing is known.
std::string error_of(const Shown& shown) {
  const Json& run = shown.run;
  for (const std::string& field : {shown.tile.field.value_or("rho"), std::string("rho")})
    if (run["errors"].contains(field))
      return fmt::format("L1({}) {:.2g}", field, run["errors"][field]["l1"].get<double>());
  for (const auto& [measure, deviation] : run["deviations"].items())
    return fmt::format("{} off by {:.2g} %", measure == "cloud_mass" ? "cloud's mass" : measure,
                       100 * deviation["l1"].get<double>());
  return fmt::format("energy drift {:.0e}", run["conservation"]["energy"].get<double>());
}

std::string scheme_of(const Json& run) {
  return fmt::format("{} {} {:g}", run["scheme"].get<std::string>(), run["kernel"].get<std::string>(),
                     run["neighbours"].get<double>());
}

std::string particles_of(const Json& run) {
  return with_prefix(run["particles"]) + " particles";
}

std::string seconds_of(const Json& run) {
  return duration_text(run["cpu_seconds"]);
}

std::string words_of(const Shown& shown) {
  if (!shown.failure.empty()) return "failed: " + shown.failure;
  return fmt::format("{}, {}, {} in {}", scheme_of(shown.run), particles_of(shown.run), error_of(shown),
                     seconds_of(shown.run));
}

fs::path thumbnail(const Shown& shown) {
  return shown.folder / "thumbnail.png";
}

/// Draws the thumbnails and the sheet with all of them.
void draw(const std::vector<Shown>& tiles, const fs::path& sheet) {
  Json items = Json::array();
  for (const Shown& shown : tiles) {
    if (!shown.failure.empty()) continue;
    Json item = describe_snapshot(shown.folder / "snap_0001.hdf5",
                                  resolve_problem((shown.folder / "scene.used.toml").string(), {}), true);
    item["field"] = shown.tile.field.value_or(item["map"].get<bool>() ? "" : "rho");
    item["heading"] = shown.scene->name();
    item["words"] = {scheme_of(shown.run) + ", " + particles_of(shown.run),
                     error_of(shown) + " in " + seconds_of(shown.run)};
    item["out"] = thumbnail(shown).string();
    items.push_back(item);
  }
  if (!items.empty()) run_plot_script(Json{{"gallery", items}, {"out", sheet.string()}}.dump());
}

std::string command_of(const Shown& shown) {
  std::string text = "sphk run";
  for (const std::string& word : arguments_of(shown)) text += " " + word;
  return text;
}

std::string page_of(const std::vector<Shown>& tiles) {
  std::string body = fmt::format(
      "<h1>sphk: the gallery</h1>\n<p class=\"meta\">A small run of every scene, in CPU seconds of the time loop on "
      "{}. "
      "Points are particles or their means, lines the exact solution.</p>\n<div class=\"tiles\">\n",
      html_text(machine_name()));
  for (const Shown& shown : tiles) {
    const bool there = shown.failure.empty();
    const std::string name = shown.scene->name();
    body += fmt::format(
        "<figure>{}<figcaption><b>{}</b>: {}<br>{}<br><details><summary>command</summary><code>{}</code></details>"
        "</figcaption></figure>\n",
        there ? html_image(thumbnail(shown), name) : "", html_text(name), html_text(shown.scene->summary()),
        html_text(words_of(shown)), html_text(command_of(shown)));
  }
  return html_page("sphk: the gallery", body + "</div>\n");
}

}  // namespace

bool make_gallery(const GalleryRequest& request) {
  for (const std::string& name : request.scenes) find_scene(name);
  std::vector<const Scene*> wanted;
  for (const Scene* scene : scenes())
    if (request.scenes.empty() || std::ranges::find(request.scenes, scene->name()) != request.scenes.end())
      wanted.push_back(scene);
  const fs::path folder = request.out.value_or("gallery");
  fs::create_directories(folder);
  catch_stop_signals();
  std::vector<Shown> tiles;
  for (const Scene* scene : wanted) {
    fmt::print("[{}/{}] {} ...", tiles.size() + 1, wanted.size(), scene->name());
    std::fflush(stdout);
    tiles.push_back(show(*scene, folder, request.threads));
    if (stop_requested()) {
      fmt::print(" stopped\n");
      return false;
    }
    fmt::print(" {}\n", words_of(tiles.back()));
  }
  draw(tiles, folder / "gallery.png");
  write_atomically(folder / "index.html", page_of(tiles));
  fmt::print("{}\n", (folder / "index.html").string());
  return std::ranges::all_of(tiles, [](const Shown& shown) { return shown.failure.empty(); });
}

}  // namespace sphk
