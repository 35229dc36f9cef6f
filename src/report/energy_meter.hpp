// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace sphk {

/// What the processors of the machine draw, by their own counters (RAPL, as Linux shows them under powercap). They
/// count everything that runs on the machine.
class EnergyMeter {
 public:
  explicit EnergyMeter(const std::filesystem::path& powercap = "/sys/class/powercap");

  /// Energy since this meter was made, in J; nothing where there are no counters or they may not be read. A counter
  /// that has begun again from zero is followed, if it is read often enough (once a minute).
  std::optional<double> joules();

 private:
  struct Counter {
    std::filesystem::path file;
    double range = 0, last = 0;  ///< microjoules
  };
  std::vector<Counter> counters_;
  double microjoules_ = 0;
};

}  // namespace sphk
