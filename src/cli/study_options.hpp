#pragma once

#include <string>
#include <vector>

#include "src/study/study_request.hpp"

namespace CLI {
class App;
}

namespace sphk {

/// The options of `sphk study`: what is studied into `studies`, axes and the like into `study`, --set into `sets`,
/// --out into `out`, --report into `report`.
void add_study_options(CLI::App& app, StudyRequest& study, std::vector<std::string>& studies,
                       std::vector<std::string>& sets, std::string& out, std::string& report);

}  // namespace sphk
