// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// SIGINT and SIGTERM, whatever the command is doing.
#include <chrono>
#include <csignal>
#include <thread>

#include "autodiff_sim/base/sanitized.h"
#include "tests/apps/command.h"
#include "tests/support/small_recording.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using std::chrono::milliseconds;

// Each takes seconds.
const std::vector<std::vector<std::string>> kInterruptedCommands = {
    {"fit", "rec", "-o", "out"},
    {"diagnose", "rec", "-o", "out"},
    {"simulate", "rec", "-o", "out", "--resolution", "61", "61"},
    {"synthesize", "-o", "out", "--frames", "600", "--resolution", "31", "31"},
    {"compare", "rec", "-o", "out"},
    {"batch", "list.yaml", "-o", "out"},
    {"trials", "quick", "-o", "out"},
    {"study", "mesh", "-o", "out"},
    {"track", CLOTHFIT_SOURCE_DIR "/data/lift", "-o", "out"},
    {"report", CLOTHFIT_SOURCE_DIR "/data/lift", "-o", "out"}};

struct Moment {
  bool is_listening;   // wait until the command has its handlers
  milliseconds later;  // and then
  bool has_second = false;
};
constexpr Moment kMoments[] = {{false, milliseconds(0)},
                               {true, milliseconds(0)},
                               {true, milliseconds(100)},
                               {true, milliseconds(100), true}};

// The first may take 1.8 s, with sanitizers 18 s, and what a busy machine takes; the second may
// not.
constexpr double kFirst = kIsSanitized ? 20.0 : 3.0, kSecond = kIsSanitized ? 10.0 : 1.2;  // s

class InterruptedCommand : public testing::TestWithParam<std::vector<std::string>> {
 protected:
  void SetUp() override {
    SmallRecordingOptions options;
    options.particles = 5;
    options.frames = 20;
    WriteRecording(MakeSmallRecording(options), folder_.path() / "rec");
    folder_.Write("list.yaml", "fits:\n  - recording: rec\n");
  }

  // Signals the command at that moment and expects its end.
  void EndAt(const Moment& moment, int signal) {
    RunningCommand command(GetParam(), folder_.path());
    while (moment.is_listening && !(command.Handles(SIGINT) && command.Handles(SIGTERM))) {
      ASSERT_FALSE(command.HasEnded()) << command.Wait().err;
      std::this_thread::sleep_for(milliseconds(1));
    }
    std::this_thread::sleep_for(moment.later);
    const auto begin = std::chrono::steady_clock::now();
    command.Signal(signal);
    // Two of the same might be taken for one.
    if (moment.has_second) command.Signal(signal == SIGINT ? SIGTERM : SIGINT);
    const CommandResult result = command.Wait();
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(passed.count(), moment.has_second ? kSecond : kFirst);
    // Before the program's first instruction the system itself ends it; a shell calls that 130 or
    // 143. A quick machine may have finished by the last moments.
    EXPECT_TRUE(result.status == 130 || (!moment.is_listening && result.status == -signal) ||
                (result.status == 0 && moment.later.count() > 0))
        << result.status << ": " << result.err;
    std::error_code ignored;
    fs::remove_all(folder_.path() / "out", ignored);
  }

  TestFolder folder_;
};

TEST_P(InterruptedCommand, EndsWithinTwoSecondsAndAtOnceByTheSecond) {
  for (const Moment& moment : kMoments) {
    for (const int signal : {SIGINT, SIGTERM}) {
      SCOPED_TRACE(testing::Message()
                   << "signal " << signal << ' ' << moment.later.count() << " ms after it "
                   << (moment.is_listening ? "listens" : "began"));
      EndAt(moment, signal);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Commands, InterruptedCommand, testing::ValuesIn(kInterruptedCommands),
                         [](const auto& tested) { return tested.param.front(); });

}  // namespace
}  // namespace clothfit
