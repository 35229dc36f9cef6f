// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "src/report/run_record.hpp"

namespace sphk {

/// The text of run.json: seconds, bytes, operations, code units elsewhere; NaN becomes null.
std::string run_json(const RunRecord& record);

/// What such a text says, as far as the final table shows it. Throws InputError where it is no run.json; `name` is that
/// of its file.
RunRecord read_run_json(const std::string& text, const std::string& name);

}  // namespace sphk
