// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace sphk {

/// Forgets what was asked for before. From now on SIGTERM, SIGINT, SIGUSR1, SIGHUP (but for programs under nohup) and
/// SIGXCPU only ask for a stop. One that comes two seconds or more after the first ends the program as usual:
/// `timeout`, shells and batch systems send a stop twice, to the program and to its process group. SIGXCPU never does,
/// since it comes every second once the limit of CPU time is reached. SIGUSR2 asks for a checkpoint.
/// SIGPIPE does nothing: whoever read what is printed may go before the end.
void catch_stop_signals();
/// Has a stop been asked for?
bool stop_requested();
/// Has a checkpoint been asked for since the last call?
bool checkpoint_requested();

}  // namespace sphk
