// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "src/report/run_record.hpp"

namespace sphk {

/// The closing table of a run: seconds by phase, rates, share of the measured peak, memory, conservation, error norms.
std::string final_table(const RunRecord& record);

}  // namespace sphk
