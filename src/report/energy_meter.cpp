// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/energy_meter.hpp"

#include <fstream>
#include <string>

namespace sphk {

namespace fs = std::filesystem;

namespace {

std::optional<double> number_in(const fs::path& path) {
  std::ifstream file(path);
  double number = 0;
  return file >> number ? std::optional<double>(number) : std::nullopt;
}

/// A processor has one colon in its name, intel-rapl:0; its parts, intel-rapl:0:1, have two.
bool is_processor(const std::string& name) {
  return name.starts_with("intel-rapl:") && name.find(':') == name.rfind(':');
}

}  // namespace

EnergyMeter::EnergyMeter(const fs::path& powercap) {
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(powercap, missing)) {
    if (!is_processor(entry.path().filename().string())) continue;
    const auto now = number_in(entry.path() / "energy_uj"), range = number_in(entry.path() / "max_energy_range_uj");
    if (now && range) counters_.push_back({entry.path() / "energy_uj", *range, *now});
  }
}

std::optional<double> EnergyMeter::joules() {
  if (counters_.empty()) return std::nullopt;
  for (Counter& counter : counters_) {
    const double now = number_in(counter.file).value_or(counter.last);
    microjoules_ += now - counter.last + (now < counter.last ? counter.range : 0);
    counter.last = now;
  }
  return 1e-6 * microjoules_;
}

}  // namespace sphk
