#pragma once

#include "src/study/study_request.hpp"

namespace sphk {

/// Error against run time over every combination of schemes, kernels, resolutions, ...: each run is a process of its
/// own. Tells on standard output how far it is and what it found. Leaves study.json (every run, raw), study.csv,
/// study.png and the page that `report` names. A signal stops it (stop_signal.hpp); asked again, it goes on where it
/// was. Throws InputError.
void study(const StudyRequest& request);

}  // namespace sphk
