// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/stop_signal.hpp"

#include <atomic>
#include <csignal>
#include <ctime>
#include <initializer_list>

namespace sphk {

namespace {

volatile std::sig_atomic_t stop_flag = 0, checkpoint_flag = 0;
std::atomic<std::time_t> asked_at{0};  // seconds
static_assert(std::atomic<std::time_t>::is_always_lock_free, "a signal handler may not wait for a lock");

std::time_t seconds_now() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec;
}

void ask_for_stop(int signal) {
  if (stop_flag == 0) {
    asked_at = seconds_now();
    stop_flag = 1;
  } else if (signal != SIGXCPU && seconds_now() - asked_at > 1) {  // that one comes every second until the hard limit
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

void ask_for_checkpoint(int) {
  checkpoint_flag = 1;
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

bool is_ignored(int signal) {
  struct sigaction now {};
  return sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

void catch_stop_signals() {
  stop_flag = 0;
  for (const int signal : {SIGTERM, SIGINT, SIGUSR1, SIGXCPU}) handle(signal, ask_for_stop);
  if (!is_ignored(SIGHUP)) handle(SIGHUP, ask_for_stop);  // under nohup it is
  handle(SIGUSR2, ask_for_checkpoint);
  std::signal(SIGPIPE, SIG_IGN);
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
