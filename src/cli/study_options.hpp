#pragma once

#include <string>
#include <vector>

#include "src/cli/commands.hpp"

namespace CLI {
class App;
}

namespace sphk {

/// The options of `sphk study`: axes into `study`, --set into `sets`, --out into `out`, --report into `report`.
void add_study_options(CLI::App& app, StudyOptions& study, std::vector<std::string>& sets, std::string& out,
                       std::string& report);

}  // namespace sphk
