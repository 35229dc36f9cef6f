#include "src/run/stop_signal.hpp"

#include <csignal>
#include <initializer_list>

namespace sphk {

namespace {

volatile std::sig_atomic_t stop_flag = 0, checkpoint_flag = 0;

void ask_for_stop(int) {
  stop_flag = 1;
}

void ask_for_checkpoint(int) {
  checkpoint_flag = 1;
}

void handle(int signal, void (*handler)(int), int flags) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART | flags;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

void catch_stop_signals() {
  stop_flag = 0;
  for (const int signal : {SIGTERM, SIGINT, SIGUSR1}) handle(signal, ask_for_stop, static_cast<int>(SA_RESETHAND));
  handle(SIGUSR2, ask_for_checkpoint, 0);
}

bool stop_requested() {
  return stop_flag != 0;
}

bool checkpoint_requested() {
  const bool asked = checkpoint_flag != 0;
  checkpoint_flag = 0;
  return asked;
}

}  // namespace sphk
