// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/io/reader.hpp"

namespace sphk {

/// One kind of problem among the particles, with the first few that show it.
struct Finding {
  /// `error`: no run can start from this. `notice`: it can, but it is rarely meant (coincident, outside the box).
  enum class Severity { error, notice };
  struct Example {
    std::size_t index = 0;  ///< row, from 0
    std::uint64_t id = 0;
    Array3 x{};
  };
  Severity severity = Severity::error;
  std::string problem;  ///< such as "zero or negative mass"
  std::size_t count = 0;
  std::vector<Example> examples;
};

/// NaN and infinities, zero or negative masses, negative specific thermal energies and smoothing lengths, duplicate
/// ids, particles at exactly the same place and particles outside the box: an error where more than a few percent lie
/// more than a box length outside a periodic one, whose unit must be another then. Empty when all is well. O(n log n).
std::vector<Finding> check_particles(const ParticleSet& particles);

/// One line: the count, the problem, index, id and position of the first few.
std::string to_text(const Finding& finding);

/// What is to be said of a file's gas before it runs, alike in every command.
struct Verdict {
  std::vector<std::string> notes;   ///< what the reader assumed, made or left out, and notices
  std::vector<std::string> errors;  ///< why no run can start from it
};
Verdict judge(const ReadResult& content);

/// Why it is in doubt how many dimensions the gas has: all its particles have one coordinate in common, and nothing
/// says that this is meant. Empty where there is no doubt.
std::string dimension_in_doubt(const ReadResult& content);

}  // namespace sphk
