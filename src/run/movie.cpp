// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/movie.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/engine/errors.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/report/plot_script.hpp"
#include "src/report/process.hpp"

namespace sphk {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

/// The snapshots of a run that a film may show.
struct Reel {
  std::optional<Problem> problem;
  std::vector<fs::path> snapshots;
  std::vector<double> times;

  const fs::path& nearest(double time) const {
    const auto gap = [time](double other) { return std::abs(other - time); };
    return snapshots[static_cast<std::size_t>(std::ranges::min_element(times, {}, gap) - times.begin())];
  }
};

Reel reel_of(const std::string& what) {
  const PlotTargets targets = find_targets(what, true);
  Reel reel{targets.problem(), targets.snapshots, {}};
  for (const fs::path& snapshot : targets.snapshots) {
    const std::vector<double> time = hdf5::File::open(snapshot).group("Header").numbers_or("Time", {0});
    reel.times.push_back(time.empty() ? 0 : time[0]);
  }
  return reel;
}

/// The times of a film: of the run with most snapshots every k-th one, and the last.
std::vector<double> times_of(const std::vector<Reel>& reels, int every) {
  const auto count = [](const Reel& reel) { return reel.times.size(); };
  const std::vector<double>& all = std::ranges::max_element(reels, {}, count)->times;
  std::vector<double> times;
  for (std::size_t k = 0; k < all.size(); k += static_cast<std::size_t>(every)) times.push_back(all[k]);
  if ((all.size() - 1) % static_cast<std::size_t>(every) != 0) times.push_back(all.back());
  return times;
}

/// What shows the gas of all pictures, where it moves in an open box. Throws InputError where there is no map of one.
std::vector<double> common_window(const MovieRequest& request, const std::vector<Reel>& reels,
                                  const std::vector<double>& times) {
  std::vector<double> all;
  for (const Reel& reel : reels)
    for (const double time : times) {
      NumberFiles none;
      const PlotItem item(reel.nearest(time), reel.problem, none);
      if (time == times.front()) check_map(request.view, item);
      const auto own = item.extent();
      if (all.empty()) all.assign(own.begin(), own.end());
      for (std::size_t k = 0; k < 4; k += 2) {
        all[k] = std::min(all[k], own[k]);
        all[k + 1] = std::max(all[k + 1], own[k + 1]);
      }
      if (item.fills_box()) break;
    }
  return all;
}

void check(const MovieRequest& request) {
  request.view.check();
  const std::string ending = request.out.extension().string();
  if (ending != ".mp4" && ending != ".gif" && ending != ".html")
    throw InputError(
        fmt::format("--out {}: films are .mp4, .gif or .html files (a page with the pictures in it), so write {}",
                    request.out.string(), fs::path(request.out).replace_extension(".mp4").string()));
  if (ending == ".mp4" && Process({"ffmpeg", "-version"}, {.output = "/dev/null"}).wait() != 0)
    throw InputError(
        fmt::format("--out {}: this needs ffmpeg, which is not there: sudo apt-get install ffmpeg; or ask for {} or "
                    "{}, which need nothing",
                    request.out.string(), fs::path(request.out).replace_extension(".gif").string(),
                    fs::path(request.out).replace_extension(".html").string()));
}

}  // namespace

void make_movie(const MovieRequest& request) {
  check(request);
  std::vector<Reel> reels;
  for (const std::string& what : request.what) reels.push_back(reel_of(what));
  const std::vector<double> times = times_of(reels, request.every);
  FieldView view = request.view;
  const std::vector<double> window = common_window(request, reels, times);
  if (view.map.window.empty()) view.map.window = window;
  NumberFiles files;
  Json frames = Json::array();
  for (const double time : times) {
    Json frame = Json::array();
    for (const Reel& reel : reels) {
      PlotItem item(reel.nearest(time), reel.problem, files);
      check_field(view, item);
      item.add_map(view.name(), view.map);
      frame.push_back(item.json);
    }
    if (frames.empty()) require_same_units(frame);
    frames.push_back(frame);
  }
  run_plot_script(Json{{"movie", frames},
                       {"field", view.name()},
                       {"view", view.json()},
                       {"fps", request.fps},
                       {"out", request.out.string()}}
                      .dump());
}

}  // namespace sphk
