#pragma once

namespace sphk {

/// From now on the first SIGTERM or SIGINT only asks for a stop; a second one ends the program as usual.
void catch_stop_signals();
/// Has a stop been asked for?
bool stop_requested();

}  // namespace sphk
