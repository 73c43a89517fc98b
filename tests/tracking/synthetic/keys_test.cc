// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/synthetic/keys.h"

#include "tests/support/test_folder.h"
#include "tracking/synthetic/presets.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

SyntheticOptions FromYaml(const std::string& text) {
  const TestFolder folder;
  return MakeSyntheticOptions(ReadSyntheticConfig(folder.Write("made.yaml", text)));
}

std::string ProblemOf(const std::string& text) {
  return InputErrorOf([&] { FromYaml(text); });
}

TEST(SyntheticKeys, ReadBackAsTheyAreWritten) {
  for (const std::string& name : PresetNames()) {
    SyntheticOptions options = PresetOptions("--preset", name);
    options.hidden_handles = {"corner"};
    options.tell_density = false;
    options.pictures.video = "mkv";
    options.pictures.distortion = {-0.1, 0.02, 0.001, 0.0, 0.5};
    const std::string text = SyntheticConfigAsYaml(options);
    EXPECT_EQ(SyntheticConfigAsYaml(FromYaml(text)), text);
    for (const SyntheticKey& key : SyntheticKeys())
      EXPECT_THAT("\n" + text, HasSubstr("\n" + key.name + ":")) << key.name;
  }
}

TEST(SyntheticKeys, EachChangesSomething) {
  const SyntheticOptions defaults;
  for (const SyntheticKey& key : SyntheticKeys()) {
    const std::vector<std::string> before = key.words(defaults);
    SyntheticOptions changed;
    std::string problem = "none tried";
    // One of these suits each kind of key and is no default.
    for (const char* word : {"air_drag.normal=3", "false", "true", "plain", "corner-lift", "7"}) {
      const std::size_t count = key.kind == SyntheticKey::Kind::kValues
                                    ? static_cast<std::size_t>(key.count)
                                    : std::size_t{1};
      changed = defaults;
      problem = key.set(std::vector<std::string>(count, word), &changed);
      if (problem.empty() && key.words(changed) != before) break;
    }
    EXPECT_EQ(problem, "") << key.name;
    EXPECT_NE(key.words(changed), before) << key.name;
    EXPECT_EQ(key.option.substr(0, 2), "--");
  }
}

TEST(SyntheticKeys, ChangeAPreset) {
  const SyntheticOptions options =
      FromYaml("preset: experiment-2\nframes: 12\nparameters: {air_drag.normal: 2}\n");
  EXPECT_EQ(options.frame_count, 12);
  EXPECT_EQ(options.pictures.pattern, ClothPattern::kRepetitive);
  EXPECT_EQ(options.parameters.at("air_drag.normal"), 2.0);
  EXPECT_EQ(options.parameters.at("cloth.areal_density"), 0.18);  // the preset's
}

TEST(SyntheticKeys, ImagesComeWithTheirOwnDefaults) {
  const SyntheticOptions options = FromYaml("images: true\nsamples: 3\n");
  EXPECT_EQ(options.num_cameras, 7);
  EXPECT_EQ(options.refinement, 2);
  EXPECT_EQ(options.markers, Eigen::Vector2i(0, 0));
  EXPECT_FALSE(options.tracks);
  EXPECT_EQ(options.pictures.samples, 3);
}

TEST(SyntheticKeys, TellWhatIsWrong) {
  EXPECT_THAT(ProblemOf("textur: plain\n"), HasSubstr("did you mean 'texture'?"));
  EXPECT_THAT(ProblemOf("texture: plane\n"),
              HasSubstr("made.yaml: texture: 'plane': did you mean"));
  EXPECT_THAT(ProblemOf("preset: experiment-9\n"), HasSubstr("made.yaml: preset: 'experiment-9'"));
  EXPECT_THAT(ProblemOf("size: [1, 2, 3]\n"), HasSubstr("expected a list of 2 numbers, found 3"));
  EXPECT_THAT(ProblemOf("steps: 1.5\n"), HasSubstr("steps: '1.5': expected an integer"));
  EXPECT_THAT(ProblemOf("images: maybe\n"), HasSubstr("expected true or false"));
  EXPECT_THAT(ProblemOf("seed: -1\n"), HasSubstr("seed: '-1': expected an integer of 0 or more"));
}

TEST(SyntheticPresets, AreOfUse) {
  for (const std::string& name : PresetNames()) {
    const SyntheticOptions options = PresetOptions("--preset", name);
    EXPECT_NO_THROW(options.Check(name)) << name;
    EXPECT_EQ(options.num_cameras, 7);
  }
}

TEST(SyntheticOptions, RefuseUselessPictures) {
  const auto problem_of = [](const std::function<void(SyntheticOptions*)>& spoil) {
    SyntheticOptions options = ImageOptions();
    spoil(&options);
    return InputErrorOf([&] { options.Check("synthesize"); });
  };
  EXPECT_THAT(problem_of([](SyntheticOptions* o) { o->num_cameras = 0; }), HasSubstr("cameras"));
  EXPECT_THAT(problem_of([](SyntheticOptions* o) { o->pictures.samples = 0; }),
              HasSubstr("samples: 0: expected 1 to 16"));
  EXPECT_THAT(problem_of([](SyntheticOptions* o) {
                o->pictures.size = {4, 4};
              }),
              HasSubstr("picture_size: 4 4: expected"));
  EXPECT_THAT(problem_of([](SyntheticOptions* o) { o->pictures.noise = -1.0; }),
              HasSubstr("sensor_noise: -1: expected"));
  EXPECT_THAT(problem_of([](SyntheticOptions* o) { o->pictures.video = "mkw"; }),
              HasSubstr("video: mkw: expected mkv, mp4, avi or none"));
}

}  // namespace
}  // namespace clothfit
