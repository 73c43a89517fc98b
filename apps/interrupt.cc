// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/interrupt.h"

#include <csignal>
#include <string_view>

#include <unistd.h>

#include "apps/commands.h"

namespace clothfit {
namespace {

std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may not wait");

extern "C" void HandleInterrupt(int /*signal*/) {
  if (stop_requested.exchange(true)) _exit(kExitInterrupted);
  constexpr std::string_view kMessage =
      "\nclothfit: stopping and keeping the best so far; once more to end at once\n";
  const ssize_t ignored = write(STDERR_FILENO, kMessage.data(), kMessage.size());
  static_cast<void>(ignored);
}

}  // namespace

const std::atomic<bool>* StopOnInterrupt() {
  struct sigaction action = {};
  action.sa_handler = HandleInterrupt;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  return &stop_requested;
}

}  // namespace clothfit
