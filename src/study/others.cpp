#include "src/study/others.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "src/engine/errors.hpp"

namespace sphk {

namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> values;
  std::string value;
  for (std::istringstream text(line); std::getline(text, value, ',');) {
    const auto first = value.find_first_not_of(" \t\r"), last = value.find_last_not_of(" \t\r");
    values.push_back(first == std::string::npos ? "" : value.substr(first, last - first + 1));
  }
  return values;
}

}  // namespace

std::vector<OtherPoint> read_others(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw InputError(fmt::format("cannot read {}: is the path right?", path.string()));
  std::vector<std::string> columns;
  std::vector<OtherPoint> points;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (line.empty() || line[0] == '#') continue;
    const std::vector<std::string> values = split(line);
    const auto refuse = [&](const std::string& problem) {
      throw InputError(fmt::format("{}:{}: {}", path.string(), number, problem));
    };
    if (columns.empty()) {
      columns = values;
      for (const char* name : {"engine", "setting", "error", "cpu_seconds", "machine"})
        if (std::ranges::find(columns, name) == columns.end())
          refuse(fmt::format("no column \"{}\"; the first line is: engine,setting,error,cpu_seconds,machine", name));
      continue;
    }
    if (values.size() != columns.size()) refuse(fmt::format("{} values for {} columns", values.size(), columns.size()));
    const auto text = [&](const char* name) { return values[std::ranges::find(columns, name) - columns.begin()]; };
    const auto positive = [&](const char* name) {
      double value = 0;
      std::istringstream(text(name)) >> value;
      if (!(value > 0) || !std::isfinite(value))
        refuse(fmt::format("{} is \"{}\", a positive number is wanted", name, text(name)));
      return value;
    };
    points.push_back({text("engine"), text("setting"), positive("error"), positive("cpu_seconds"), text("machine")});
  }
  if (columns.empty())
    throw InputError(
        fmt::format("{} holds no table; its first line is: engine,setting,error,cpu_seconds,machine", path.string()));
  return points;
}

}  // namespace sphk
