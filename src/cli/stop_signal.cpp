#include "src/cli/stop_signal.hpp"

#include <csignal>

namespace sphk {

namespace {

volatile std::sig_atomic_t stop_flag = 0;

void ask_for_stop(int) {
  stop_flag = 1;
}

}  // namespace

void catch_stop_signals() {
  struct sigaction action {};
  action.sa_handler = ask_for_stop;
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGINT, &action, nullptr);
}

bool stop_requested() {
  return stop_flag != 0;
}

}  // namespace sphk
