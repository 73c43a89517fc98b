// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/c3d_file.h"
#include "tests/support/motive_file.h"
#include "tests/support/test_folder.h"
#include "tracking/import/take/file.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

// In millimetres, one marker lost in two frames.
MarkerTake SheetInMillimetres(size_t num_markers = 5) {
  std::vector<Eigen::Vector2d> uv;
  for (size_t i = 0; i < num_markers; ++i) uv.emplace_back(0.03 * double(i), 0.01 * double(i % 3));
  MarkerTake take = BentSheetTake(uv);
  for (MarkerPath& marker : take.markers) {
    for (auto& position : marker.positions) *position *= 1000.0;
  }
  take.markers[1].positions[0].reset();
  take.markers[1].positions[9].reset();
  return take;
}

class C3d : public testing::Test {
 protected:
  MarkerTake Read(const std::string& bytes, const TakeFileOptions& options = WithUp()) {
    notes_.clear();
    return ReadTake(folder_.Write("take.c3d", bytes), options, &notes_);
  }
  std::string ErrorOf(const std::string& bytes, const TakeFileOptions& options = WithUp()) {
    return InputErrorOf([&] { Read(bytes, options); });
  }

  static TakeFileOptions WithUp() {
    TakeFileOptions options;
    options.facts.up = "z";
    return options;
  }

  TestFolder folder_;
  std::vector<std::string> notes_;
};

// In metres, against a take in millimetres.
void ExpectSameInMetres(const MarkerTake& read, const MarkerTake& written, double tolerance) {
  ASSERT_EQ(NamesOf(read), NamesOf(written));
  ASSERT_EQ(read.num_frames(), written.num_frames());
  int checked = 0;
  for (size_t i = 0; i < read.markers.size(); ++i) {
    for (size_t frame = 0; frame < read.num_frames(); ++frame) {
      const auto& expected = written.markers[i].positions[frame];
      const auto& found = read.markers[i].positions[frame];
      ASSERT_EQ(found.has_value(), expected.has_value()) << i << " at " << frame;
      if (!expected) continue;
      ASSERT_LT((*found - 1e-3 * *expected).norm(), tolerance);
      ++checked;
    }
  }
  EXPECT_GT(checked, 100);
}

TEST_F(C3d, IsReadOfAllProcessorsAsFloatsAndIntegers) {
  const MarkerTake take = SheetInMillimetres();
  for (const C3dProcessor processor :
       {C3dProcessor::kIntel, C3dProcessor::kDec, C3dProcessor::kMips}) {
    for (const double scale : {-0.1, 0.05}) {
      for (const int num_analog : {0, 6}) {
        C3dFile file;
        file.processor = processor;
        file.scale = scale;
        file.num_analog = num_analog;
        const MarkerTake read = Read(file.Bytes(take));
        EXPECT_EQ(read.frame_rate, 120.0);
        // Floats have 24 bits, of places up to 2 m; integers are rounded to half a scale, in mm.
        ExpectSameInMetres(read, take, scale < 0.0 ? 5e-7 : 1e-3 * 0.9 * scale);
      }
    }
  }
}

// DART 6.12.1 (Debian 12, libdart-utils), saveC3DFile: 20 frames at 120 Hz of 3 x 2 points,
// 0.1 and 0.2 m apart. It says that its parameters are in the block of the header, has none, and
// writes millimetres with y up.
TEST_F(C3d, OfDartIsRead) {
  const auto path = std::filesystem::path(CLOTHFIT_SOURCE_DIR) / "tests" / "tracking" / "import" /
                    "c3d" / "dart.c3d";
  EXPECT_THAT(InputErrorOf([&] { ReadTake(path, {}, &notes_); }),
              HasSubstr("expected --unit (m, cm or mm), --up (the axis"));
  TakeFileOptions options;
  options.facts.up = "x";
  options.facts.metres_per_unit = 1e-3;
  const MarkerTake take = ReadTake(path, options, &notes_);
  EXPECT_EQ(take.frame_rate, 120.0);
  ASSERT_EQ(take.num_frames(), 20u);
  ASSERT_EQ(take.markers.size(), 6u);
  EXPECT_EQ(take.markers[4].name, "point 5");
  const auto place = [&](size_t marker, size_t frame) {
    return *take.markers[marker].positions[frame];
  };
  EXPECT_NEAR((place(5, 0) - place(3, 0)).norm(), 0.2, 1e-6);
  EXPECT_NEAR((place(3, 0) - place(0, 0)).norm(), 0.2, 1e-6);
  EXPECT_NEAR(place(5, 19).z() - place(5, 0).z(), -19 * 0.005 * 5, 1e-6);
}

TEST_F(C3d, HasMoreThan255Points) {
  const MarkerTake take = SheetInMillimetres(600);
  ExpectSameInMetres(Read(C3dFile().Bytes(take)), take, 2e-5);  // places up to 20 m
}

TEST_F(C3d, HasMoreThan65535Frames) {
  MarkerTake take;
  take.frame_rate = 250.0;
  take.markers = {{"a", HandleDescription::Path(70'000, Eigen::Vector3d(1.0, 2.0, 3.0))}};
  take.markers[0].positions.back() = Eigen::Vector3d(4.0, 5.0, 6.0);
  const auto last_of = [](const MarkerTake& read) { return *read.markers[0].positions.back(); };
  C3dFile file;
  EXPECT_EQ(Read(file.Bytes(take)).num_frames(), 65535u);
  file.numbers["POINT:LONG_FRAMES"] = {70'000.0F};
  EXPECT_EQ(Read(file.Bytes(take)).num_frames(), 70'000u);
  EXPECT_LT((last_of(Read(file.Bytes(take))) - Eigen::Vector3d(4e-3, 5e-3, 6e-3)).norm(), 1e-9);
  file.numbers.erase("POINT:LONG_FRAMES");
  file.words["TRIAL:ACTUAL_START_FIELD"] = {11, 0};
  file.words["TRIAL:ACTUAL_END_FIELD"] = {70'010 - 65'536, 1};
  EXPECT_EQ(Read(file.Bytes(take)).num_frames(), 70'000u);
}

TEST_F(C3d, SaysWhichAxisPointsUp) {
  C3dFile file;
  const MarkerTake take = SheetInMillimetres();
  const Eigen::Vector3d first = 1e-3 * *take.markers[0].positions[3];
  EXPECT_THAT(ErrorOf(file.Bytes(take), {}),
              HasSubstr("take.c3d: does not say all that is needed: expected --up (the axis"));
  file.texts["POINT:Y_SCREEN"] = {"+Z"};
  EXPECT_LT((*Read(file.Bytes(take), {}).markers[0].positions[3] - first).norm(), 1e-6);
  EXPECT_THAT(notes_, testing::ElementsAre(HasSubstr("z points up, as POINT:Y_SCREEN says")));
  file.texts["POINT:Y_SCREEN"] = {"-Y"};
  EXPECT_NEAR(Read(file.Bytes(take), {}).markers[0].positions[3]->z(), -first.y(), 1e-6);
  EXPECT_LT((*Read(file.Bytes(take)).markers[0].positions[3] - first).norm(), 1e-6) << "--up z";
  EXPECT_THAT(notes_, testing::IsEmpty());
}

TEST_F(C3d, LeavesOutWhatModelsComputed) {
  C3dFile file;
  file.texts["POINT:ANGLES"] = {"m2"};
  file.texts["POINT:POWERS"] = {"m4", ""};
  EXPECT_EQ(NamesOf(Read(file.Bytes(SheetInMillimetres()))),
            (std::vector<std::string>{"m0", "m1", "m3"}));
  EXPECT_THAT(notes_, testing::ElementsAre(HasSubstr("2 points are left out")));
}

TEST_F(C3d, NamesPointsThatHaveNoneOrAnothersName) {
  C3dFile file;
  file.texts["POINT:LABELS"] = {"*", "left", "*"};
  EXPECT_EQ(NamesOf(Read(file.Bytes(SheetInMillimetres()))),
            (std::vector<std::string>{"*", "left", "* (3)", "point 4", "point 5"}));
}

TEST_F(C3d, FactsThatLackAreAskedFor) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  C3dFile file;
  file.numbers["POINT:RATE"] = {nan};
  EXPECT_THAT(ErrorOf(file.Bytes(SheetInMillimetres())),
              HasSubstr("expected --rate (frames a second)"));
  file.texts["POINT:UNITS"] = {"furlong"};
  EXPECT_THAT(ErrorOf(file.Bytes(SheetInMillimetres())),
              HasSubstr("expected --rate (frames a second), --unit (m, cm or mm)"));
  TakeFileOptions options = WithUp();
  options.facts.frame_rate = 60.0;
  options.facts.metres_per_unit = 1.0;
  const MarkerTake take = Read(file.Bytes(SheetInMillimetres()), options);
  EXPECT_EQ(take.frame_rate, 60.0);
  EXPECT_GT(take.markers[0].positions[0]->norm(), 100.0);
}

TEST_F(C3d, PlacesThatAreNoNumbersAreLost) {
  MarkerTake take = SheetInMillimetres();
  (*take.markers[2].positions[4])[1] = std::nan("");
  const MarkerTake read = Read(C3dFile().Bytes(take));
  EXPECT_FALSE(read.markers[2].positions[4]);
  EXPECT_TRUE(read.markers[2].positions[5]);
}

TEST_F(C3d, RefusesLiesAboutSizes) {
  const MarkerTake take = SheetInMillimetres();
  const std::string bytes = C3dFile().Bytes(take);
  const auto with = [&](const auto& change) {
    C3dFile file;
    change(&file);
    return ErrorOf(file.Bytes(take));
  };
  EXPECT_THAT(ErrorOf(bytes.substr(0, 3000)),
              HasSubstr("take.c3d: byte 3000: the file ends; expected 60 frames of 5 points from "
                        "byte 1024 on, found 24"));
  EXPECT_THAT(ErrorOf(bytes.substr(0, 600)), HasSubstr("take.c3d: byte 600: the file ends"));
  EXPECT_THAT(with([](C3dFile* file) { file->words["POINT:USED"] = {60'000}; }),
              HasSubstr("expected 60 frames of 60000 points from byte 1024 on, found 0"));
  EXPECT_THAT(with([](C3dFile* file) { file->words["POINT:FRAMES"] = {0}; }),
              HasSubstr("POINT:FRAMES: expected a whole number above 0, found 0"));
  EXPECT_THAT(with([](C3dFile* file) { file->numbers["POINT:LONG_FRAMES"] = {1e30F}; }),
              HasSubstr("POINT:LONG_FRAMES: expected a whole number above 0, found 1.0000000"));
  EXPECT_THAT(with([](C3dFile* file) { file->scale = 0.0; }),
              HasSubstr("POINT:SCALE: expected a number other than 0, found 0"));
  EXPECT_THAT(with([](C3dFile* file) { file->words["POINT:Y_SCREEN"] = {1}; }),
              HasSubstr("POINT:Y_SCREEN: expected text, found numbers"));
  std::string broken = bytes;
  broken[kC3dBlock + 3] = 87;
  EXPECT_THAT(ErrorOf(broken), HasSubstr("take.c3d: byte 515: expected a processor, 84 (Intel), 85 "
                                         "(DEC) or 86 (MIPS), found 87"));
  broken = bytes;
  const size_t type = bytes.find("LABELS") + 6 + 2;
  broken[type] = 3;
  EXPECT_THAT(ErrorOf(broken), HasSubstr("POINT:LABELS: expected a type -1, 1, 2 or 4, found 3"));
  broken = bytes;
  broken[type + 1] = 9;
  for (size_t i = 0; i < 9; ++i) broken[type + 2 + i] = '\xFF';
  EXPECT_THAT(ErrorOf(broken),
              HasSubstr("POINT:LABELS: expected no more values than the file has bytes"));
}

TEST_F(C3d, FramesThatAreThereAreReadOnRequest) {
  TakeFileOptions options = WithUp();
  options.skip_bad_rows = true;
  EXPECT_EQ(Read(C3dFile().Bytes(SheetInMillimetres()).substr(0, 3000), options).num_frames(), 24u);
  EXPECT_THAT(notes_, testing::ElementsAre(HasSubstr("expected 60 frames of 5 points")));
}

// Whatever byte is broken, the answer is a take or an InputError.
TEST_F(C3d, SurvivesAnyByte) {
  const std::string bytes = C3dFile().Bytes(SheetInMillimetres());
  std::mt19937 random(3);
  int refused = 0;
  for (size_t at = 0; at < 1100; ++at) {
    std::string broken = bytes;
    broken[at] = static_cast<char>(random());
    try {
      Read(broken);
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 20);
}

}  // namespace
}  // namespace clothfit
