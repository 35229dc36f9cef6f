// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace sphk {

/// The processor's name, and its family and model where Linux tells them ("AMD EPYC (family 25, model 1), 2 cores").
std::string machine_name();

/// The largest memory that this process has held resident, in bytes; and what it holds now.
double peak_memory_bytes();
double memory_bytes();
/// What this machine can still give to a process, the limit of its control group heeded; infinite where nobody tells.
double available_memory_bytes();

/// Wall-clock seconds and CPU seconds of all threads of this process since its construction.
class Stopwatch {
 public:
  Stopwatch();
  double wall() const;
  double cpu() const;

 private:
  double wall_start_, cpu_start_;
};

}  // namespace sphk
