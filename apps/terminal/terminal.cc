// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/terminal/terminal.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <string>

#include <fcntl.h>
#include <unistd.h>

#include "autodiff_sim/base/printable.h"
#include "autodiff_sim/base/sanitized.h"

namespace clothfit {
namespace {

std::FILE* terminal = nullptr;
int aside = -1;  // the end from which to read what others wrote

extern "C" void ShowWhatIsAside(int signal) {
  std::array<char, 4096> bytes;
  for (ssize_t got = 0; (got = read(aside, bytes.data(), bytes.size())) > 0;) {
    if (write(fileno(terminal), bytes.data(), static_cast<std::size_t>(got)) < 0) break;
  }
  std::signal(signal, SIG_DFL);
  raise(signal);
}

}  // namespace

std::FILE* Terminal() { return terminal != nullptr ? terminal : stderr; }

void TakeTerminal() {
  std::array<int, 2> ends = {-1, -1};
  // Sanitizers report by the standard error, and are not to be kept from it.
  if (kIsSanitized || pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) return;
  const int own = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  std::FILE* const stream = own >= 0 ? fdopen(own, "w") : nullptr;
  // The pipe holds 64 kB; what comes once it is full is dropped, since nothing waits for it.
  if (stream == nullptr || dup2(ends[1], STDERR_FILENO) < 0) {
    for (const int descriptor : {ends[0], ends[1], own})
      if (descriptor >= 0) close(descriptor);
    return;
  }
  close(ends[1]);
  aside = ends[0];
  terminal = stream;
  setvbuf(terminal, nullptr, _IOLBF, BUFSIZ);
  std::signal(SIGABRT, ShowWhatIsAside);
}

void PrintLines(std::FILE* stream, std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    // An escaped byte takes four.
    shown += stream == stdout ? Printable(line, 4 * line.size() + 1) : Printable(line);
    if (end < text.size()) shown += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  std::fwrite(shown.data(), 1, shown.size(), stream);
}

}  // namespace clothfit
