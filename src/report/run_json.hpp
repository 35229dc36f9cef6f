#pragma once

#include <string>

#include "src/report/run_record.hpp"

namespace sphk {

/// The text of run.json: seconds, bytes, operations, code units elsewhere; NaN becomes null.
std::string run_json(const RunRecord& record);

}  // namespace sphk
