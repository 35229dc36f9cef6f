#pragma once

namespace sphk {

/// Forgets what was asked for before. From now on the first SIGTERM, SIGINT or SIGUSR1 only asks for a stop; a second
/// one ends the program as usual. SIGUSR2 asks for a checkpoint.
void catch_stop_signals();
/// Has a stop been asked for?
bool stop_requested();
/// Has a checkpoint been asked for since the last call?
bool checkpoint_requested();

}  // namespace sphk
