// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// fit_recording FOLDER    fits a cloth to the recording in a folder and tells what came of it
#include <cstdio>

#include <clothfit/clothfit.h>

namespace {

void Tell(const clothfit::Run& run) {
  std::printf("%s\n", run.verdict().c_str());
  for (const std::string& sentence : run.sentences()) std::printf("  %s\n", sentence.c_str());
  for (const clothfit::Estimate& e : run.estimates()) {
    if (!e.free) continue;
    std::printf("%-28s %10.4g %-8s (95 %%: %.4g to %.4g)%s\n", e.name.c_str(), e.value,
                e.unit.c_str(), e.lower, e.upper, e.determined ? "" : ", not determined");
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "fit_recording: expected the folder of a recording\n");
    return 2;
  }
  try {
    const clothfit::Recording recording = clothfit::Recording::Read(argv[1]);
    clothfit::Config config(recording);
    config.SetKey("cloth.resolution", "[7, 7]");  // coarse, so that it takes no time

    clothfit::FitOptions options;
    options.callbacks.progress = [](const std::string& stage, double share) {
      std::fprintf(stderr, "\r%3.0f %% %-40s", 100.0 * share, stage.c_str());
    };
    const clothfit::Run run = clothfit::Fit(recording, config, options);
    std::fprintf(stderr, "\n");
    Tell(run);

    // Where the middle of the cloth is in the last frame.
    const clothfit::Vector2 size = recording.size();
    const clothfit::Array at =
        run.Predict({recording.frame_count() - 1}, {{0.5 * size[0], 0.5 * size[1]}});
    std::printf("middle: %.4f %.4f %.4f m\n", at.values[0], at.values[1], at.values[2]);
  } catch (const clothfit::InputError& error) {
    std::fprintf(stderr, "fit_recording: %s\n", error.what());
    return 2;
  }
  return 0;
}
