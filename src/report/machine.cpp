// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/machine.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <limits>
#include <map>
#include <thread>

namespace sphk {

namespace {

double seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The first processor's entries of /proc/cpuinfo; empty where there is no such file.
std::map<std::string, std::string> processor() {
  std::map<std::string, std::string> entries;
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line) && !line.empty();) {
    const auto colon = line.find(':');
    if (colon == std::string::npos) continue;
    const auto value = line.find_first_not_of(' ', colon + 1);
    entries[line.substr(0, line.find_first_of("\t:"))] = value == std::string::npos ? "" : line.substr(value);
  }
  return entries;
}

}  // namespace

std::string machine_name() {
  auto cpu = processor();
  const std::string name = cpu["model name"].empty() ? "unknown processor" : cpu["model name"];
  const std::string model =
      cpu["cpu family"].empty() ? "" : fmt::format(" (family {}, model {})", cpu["cpu family"], cpu["model"]);
  return fmt::format("{}{}, {} cores", name, model, std::thread::hardware_concurrency());
}

double peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

double memory_bytes() {
  double size = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> size >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double available_memory_bytes() {
  double available = std::numeric_limits<double>::infinity();
  std::ifstream file("/proc/meminfo");
  for (std::string name; file >> name; file.ignore(std::numeric_limits<std::streamsize>::max(), '\n'))
    if (double kilobytes = 0; name == "MemAvailable:" && file >> kilobytes) available = 1024 * kilobytes;
  double limit = 0, used = 0;
  if (std::ifstream("/sys/fs/cgroup/memory.max") >> limit && std::ifstream("/sys/fs/cgroup/memory.current") >> used)
    available = std::min(available, limit - used);
  return available;
}

Stopwatch::Stopwatch() : wall_start_(seconds(CLOCK_MONOTONIC)), cpu_start_(seconds(CLOCK_PROCESS_CPUTIME_ID)) {}
double Stopwatch::wall() const {
  return seconds(CLOCK_MONOTONIC) - wall_start_;
}
double Stopwatch::cpu() const {
  return seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu_start_;
}

}  // namespace sphk
