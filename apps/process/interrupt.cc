// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/process/interrupt.h"

#include <csignal>
#include <string_view>

#include <sys/time.h>
#include <unistd.h>

#include "apps/process/exit_status.h"
#include "apps/process/signals.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/sanitized.h"

namespace clothfit {
namespace {

std::atomic<bool> stop_requested{false}, is_awaited{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may not wait");

void Say(std::string_view message) {
  const ssize_t ignored = write(fileno(Terminal()), message.data(), message.size());
  static_cast<void>(ignored);
}

void SetHandler(int signal, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

// Two seconds, to a person; instrumented code is some ten times slower.
constexpr itimerval kTooLate =
    kIsSanitized ? itimerval{{0, 0}, {18, 0}} : itimerval{{0, 0}, {1, 800'000}};  // s, us

extern "C" void HandleTooLate(int /*signal*/) {
  Say("clothfit: interrupted; what is written is whole\n");
  _exit(kExitInterrupted);
}

extern "C" void HandleInterrupt(int /*signal*/) {
  if (stop_requested.exchange(true)) _exit(kExitInterrupted);
  if (!is_awaited) {
    Say("\nclothfit: interrupted\n");
    _exit(kExitInterrupted);
  }
  Say("\nclothfit: stopping and keeping the best so far; once more to end at once\n");
  setitimer(ITIMER_REAL, &kTooLate, nullptr);
}

}  // namespace

void ListenToSignals() {
  SetHandler(SIGINT, HandleInterrupt);
  SetHandler(SIGTERM, HandleInterrupt);
  SetHandler(SIGALRM, HandleTooLate);
}

const std::atomic<bool>* StopOnInterrupt() {
  is_awaited = true;
  return &stop_requested;
}

}  // namespace clothfit
