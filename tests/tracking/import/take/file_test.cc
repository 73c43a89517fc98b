// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Tables of markers: TRC, Vicon, Qualisys and plain ones. Motive's have a test of their own.
#include "tracking/import/take/file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/motive_file.h"
#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// One marker is lost in two frames.
MarkerTake LooseSheet() {
  MarkerTake take = BentSheetTake({{0.0, 0.0}, {0.1, 0.02}, {0.2, 0.0}, {0.1, 0.2}});
  take.markers[1].positions[0].reset();
  take.markers[1].positions[9].reset();
  return take;
}

// The places of all markers in a frame, each after the separator.
std::string PlacesAt(const MarkerTake& take, size_t frame, char separator, double metres_per_unit,
                     const std::string& lost) {
  std::string text;
  for (const MarkerPath& marker : take.markers) {
    for (int axis = 0; axis < 3; ++axis) {
      text += separator;
      const auto& position = marker.positions[frame];
      text += position ? fmt::format("{:.6f}", (*position)[axis] / metres_per_unit) : lost;
    }
  }
  return text;
}

std::string NamesWith(const MarkerTake& take, const std::string& before, const std::string& after) {
  std::string text;
  for (const MarkerPath& marker : take.markers) text += before + marker.name + after;
  return text;
}

// As OpenSim has it: blanks in the first line, an empty line after the axes, line ends of Windows.
std::string Trc(const MarkerTake& take, const std::string& lost = "") {
  std::string text =
      "PathFileType  4\t(X/Y/Z) C:\\takes\\one.trc\r\n"
      "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\tOrigDataStartFrame\t"
      "OrigNumFrames\r\n";
  text += fmt::format("  {0:.1f}\t  {0:.1f}\t   {1}\t     {2}\tmm\t  {0:.1f}\t      1\t   {1}\r\n",
                      take.frame_rate, take.num_frames(), take.markers.size());
  text += "Frame#\tTime" + NamesWith(take, "\t", "\t\t") + "\r\n\t";
  for (size_t i = 1; i <= take.markers.size(); ++i) {
    text += fmt::format("\tX{0}\tY{0}\tZ{0}", i);
  }
  text += "\r\n\r\n";
  for (size_t frame = 0; frame < take.num_frames(); ++frame) {
    text += fmt::format("{}\t{:.5f}", frame + 1, double(frame) / take.frame_rate) +
            PlacesAt(take, frame, '\t', 1e-3, lost) + "\r\n";
  }
  return text;
}

// As Nexus has it: the forces of a plate come first, an empty line ends each section.
std::string Vicon(const MarkerTake& take, char comma = ',') {
  const std::string s(1, comma);
  std::string text = "Devices\n1000\n" + s + s + "Plate" + s + s + "\nFrame" + s + "Sub Frame" + s +
                     "Fx\n" + s + s + "N\n1" + s + "0" + s + "3.5\n\nTrajectories\n";
  text += fmt::format("{:g}\n", take.frame_rate) + s + NamesWith(take, s + "Cloth:", s + s) + "\n";
  text += "Frame" + s + "Sub Frame";
  std::string units = s;
  for (size_t i = 0; i < take.markers.size(); ++i) {
    text += s + "X" + s + "Y" + s + "Z";
    units += s + "mm" + s + "mm" + s + "mm";
  }
  text += "\n" + units + "\n";
  for (size_t frame = 0; frame < take.num_frames(); ++frame) {
    text +=
        fmt::format("{}{}0", frame + 201, comma) + PlacesAt(take, frame, comma, 1e-3, "") + "\n";
  }
  return text + "\nEvents\n";
}

std::string Qualisys(const MarkerTake& take, bool has_columns, const std::string& lost) {
  std::string text = fmt::format(
      "NO_OF_FRAMES\t{}\nNO_OF_CAMERAS\t8\nNO_OF_MARKERS\t{}\nFREQUENCY\t{:g}\nNO_OF_ANALOG\t0\n"
      "ANALOG_FREQUENCY\t0\nDESCRIPTION\t--\nTIME_STAMP\t2024-05-06, 10:11:12\t37.5\n"
      "DATA_INCLUDED\t3D\nMARKER_NAMES",
      take.num_frames(), take.markers.size(), take.frame_rate);
  text += NamesWith(take, "\t", "") + "\n";
  if (has_columns) {
    text += "TRAJECTORY_TYPES" + std::string(take.markers.size(), '\t') + "Measured\nFrame\tTime";
    for (const MarkerPath& marker : take.markers) {
      text += fmt::format("\t{0} X\t{0} Y\t{0} Z", marker.name);
    }
    text += "\n";
  }
  for (size_t frame = 0; frame < take.num_frames(); ++frame) {
    std::string places = PlacesAt(take, frame, '\t', 1e-3, lost);
    if (!has_columns) places.erase(0, 1);
    if (has_columns) text += fmt::format("{}\t{:.5f}", frame + 1, double(frame) / take.frame_rate);
    text += places + "\n";
  }
  return text;
}

std::string Plain(const MarkerTake& take, bool has_frame, bool has_time, char comma = ',') {
  std::string text = has_frame ? "frame" : "";
  if (has_time) text += (text.empty() ? "" : std::string(1, comma)) + "Time";
  for (const MarkerPath& marker : take.markers) {
    text += fmt::format("{1}{0}_x{1}{0}_y{1}{0}_z", marker.name, comma);
  }
  text += "\n";
  for (size_t frame = 0; frame < take.num_frames(); ++frame) {
    std::string row = has_frame ? std::to_string(frame) : "";
    if (has_time) {
      row += (row.empty() ? "" : std::string(1, comma)) +
             fmt::format("{:.6f}", 3.0 + double(frame) / take.frame_rate);
    }
    text += row + PlacesAt(take, frame, comma, 1.0, "NaN") + "\n";
  }
  return text;
}

class TakeFile : public testing::Test {
 protected:
  MarkerTake Read(const std::string& text, const TakeFileOptions& options = WithUp()) {
    notes_.clear();
    return ReadTake(folder_.Write("take.txt", text), options, &notes_);
  }
  std::string ErrorOf(const std::string& text, const TakeFileOptions& options = WithUp()) {
    return InputErrorOf([&] { Read(text, options); });
  }
  static TakeFileOptions WithUp() {
    TakeFileOptions options;
    options.facts.up = "z";
    return options;
  }
  static TakeFileOptions InMetres() {
    TakeFileOptions options = WithUp();
    options.facts.metres_per_unit = 1.0;
    return options;
  }
  static std::string With(std::string text, const std::string& from, const std::string& to) {
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  }

  TestFolder folder_;
  std::vector<std::string> notes_;
};

void ExpectSame(const MarkerTake& read, const MarkerTake& written, const std::string& prefix = "") {
  ASSERT_EQ(read.markers.size(), written.markers.size());
  ASSERT_EQ(read.num_frames(), written.num_frames());
  // Rates are written, or follow from times that are, to six digits or more.
  EXPECT_NEAR(read.frame_rate, written.frame_rate, 0.02);
  for (size_t i = 0; i < read.markers.size(); ++i) {
    EXPECT_EQ(read.markers[i].name, prefix + written.markers[i].name);
    for (size_t frame = 0; frame < read.num_frames(); ++frame) {
      const auto& expected = written.markers[i].positions[frame];
      const auto& found = read.markers[i].positions[frame];
      ASSERT_EQ(found.has_value(), expected.has_value()) << i << " at " << frame;
      if (!expected) continue;
      ASSERT_LT((*found - *expected).norm(), 2e-6);  // written to a micrometre
    }
  }
}

TEST_F(TakeFile, ReadsTrc) {
  const MarkerTake take = LooseSheet();
  for (const char* lost : {"", "NaN"}) {
    ExpectSame(Read(Trc(take, lost)), take);
    EXPECT_THAT(notes_, IsEmpty());
  }
  // What editors make of it that strip tabs at the end of lines.
  MarkerTake without_last = take;
  without_last.markers.back().positions[4].reset();
  ExpectSame(Read(With(Trc(without_last), "\t\t\t\r\n6\t", "\r\n6\t")), without_last);
}

TEST_F(TakeFile, RefusesBrokenTrc) {
  const std::string text = Trc(LooseSheet());
  EXPECT_THAT(ErrorOf(text, {}), HasSubstr("take.txt: does not say all that is needed: expected "
                                           "--up (the axis that points up: z is usual of Vicon"));
  EXPECT_THAT(ErrorOf(With(text, "\tmm\t", "\tin\t")),
              HasSubstr("take.txt: line 3: Units: expected m, cm or mm, found 'in'"));
  EXPECT_THAT(ErrorOf(With(text, "  120.0\t", "  fast\t")),
              HasSubstr("take.txt: line 3: DataRate: expected a number above 0, found 'fast'"));
  EXPECT_THAT(ErrorOf(With(text, "Frame#\tTime", "Frame#\tClock")),
              HasSubstr("take.txt: line 4: expected 'Frame#', 'Time'"));
  EXPECT_THAT(ErrorOf(With(text, "m2\t\t\t", "m2\t\t")),
              HasSubstr("take.txt: line 4, column 11: 'm3': expected three columns a marker"));
  EXPECT_THAT(ErrorOf(With(text, "\t1000.000000\t", "\t1o\t")),
              HasSubstr("take.txt: line 7, column 5: m0 Z: expected a finite number or nothing, "
                        "found '1o'"));
  EXPECT_THAT(ErrorOf(With(text, "\n3\t", "\n3.5\t")),
              HasSubstr("line 9, column 1: Frame: expected an integer, found '3.5'"));
  EXPECT_THAT(ErrorOf(With(text, "\n60\t0.49167\t", "\n60\t0.99167\t")),
              HasSubstr("Time: expected 0.492 after 59 frames at 120 Hz, found 0.992"));
  EXPECT_THAT(ErrorOf(text.substr(0, text.find("\n1\t"))),
              HasSubstr("expected rows of data after the header, found none"));
  EXPECT_THAT(ErrorOf(text.substr(0, 40)), HasSubstr("expected the names DataRate, Units"));
  EXPECT_THAT(ErrorOf(With(text, "\n60\t", "\n3000000\t")), HasSubstr("Time: expected"));
  Read(text.substr(0, text.find("\n60\t") + 1));
  EXPECT_THAT(notes_, ElementsAre("the header says 60 frames, but 59 rows are there"));
}

TEST_F(TakeFile, ReadsVicon) {
  const MarkerTake take = LooseSheet();
  for (const char comma : {',', '\t', ';'}) {
    const MarkerTake read = Read(Vicon(take, comma));
    ASSERT_EQ(read.bodies.size(), 0u);
    ExpectSame(read, take, "Cloth:");
  }
  const std::string text = Vicon(take);
  EXPECT_THAT(ErrorOf(With(text, "\n120\n", "\n\n")), HasSubstr("Trajectories: rate: expected"));
  EXPECT_THAT(ErrorOf(With(text, "Cloth:m2", "")),
              HasSubstr("line 12, column 9: Trajectories: expected a name above this marker"));
  EXPECT_THAT(ErrorOf(With(text, "mm,mm", "ft,mm")),
              HasSubstr("Trajectories: unit: expected m, cm or mm, found 'ft'"));
  EXPECT_THAT(ErrorOf(With(text, "\n202,0,0.0", "\n202,0,O.0")),
              HasSubstr("line 14, column 3: Cloth:m0 X: expected a finite number or nothing"));
}

TEST_F(TakeFile, ReadsQualisys) {
  const MarkerTake take = LooseSheet();
  for (const char* lost : {"0.000", "", "NULL"}) {
    for (const bool has_columns : {false, true}) {
      const std::string text = Qualisys(take, has_columns, lost);
      if (std::string(lost) == "NULL") {
        EXPECT_THAT(ErrorOf(text), HasSubstr("m1 X: expected a finite number or nothing"));
      } else {
        ExpectSame(Read(text), take);
        EXPECT_THAT(notes_, IsEmpty());
      }
    }
  }
  const std::string text = Qualisys(take, true, "");
  EXPECT_THAT(ErrorOf(With(text, "\t3D\n", "\t6D\n")),
              HasSubstr("line 9, column 2: DATA_INCLUDED: expected 3D, found '6D'"));
  EXPECT_THAT(ErrorOf(With(text, "MARKER_NAMES", "NAMES")),
              HasSubstr("expected a line 'MARKER_NAMES', found the end"));
  EXPECT_THAT(ErrorOf(With(text, "FREQUENCY\t120", "FREQUENCY\t-1")),
              HasSubstr("line 4: FREQUENCY: expected a number above 0, found '-1'"));
  EXPECT_THAT(ErrorOf(With(text, "\tm2\t", "\tm0\t")), HasSubstr("two markers are named 'm0'"));
}

TEST_F(TakeFile, ReadsPlainTables) {
  const MarkerTake take = LooseSheet();
  TakeFileOptions with_rate = InMetres();
  with_rate.facts.frame_rate = 120.0;
  for (const char comma : {',', '\t', ';'}) {
    ExpectSame(Read(Plain(take, true, true, comma), InMetres()), take);
    ExpectSame(Read(Plain(take, false, true, comma), InMetres()), take);
    ExpectSame(Read(Plain(take, true, false, comma), with_rate), take);
  }
}

TEST_F(TakeFile, PlainTablesMayLeaveFramesOut) {
  const std::string text =
      "time;left X;left Y;left Z;force\n0.00;1;2;3;9\n0.01;1;2;3;9\n0.02;1;2;3;9\n0.05;4;5;6;9\n";
  const MarkerTake take = Read(text, InMetres());
  EXPECT_NEAR(take.frame_rate, 100.0, 1e-9);
  ASSERT_EQ(take.num_frames(), 6u);
  EXPECT_EQ(take.markers[0].name, "left");
  EXPECT_FALSE(take.markers[0].positions[3]);
  EXPECT_EQ(*take.markers[0].positions[5], Eigen::Vector3d(4.0, 5.0, 6.0));
  EXPECT_THAT(notes_, ElementsAre("columns that are left out: force"));
}

TEST_F(TakeFile, RefusesBrokenPlainTables) {
  const std::string text = Plain(LooseSheet(), true, false);
  EXPECT_THAT(ErrorOf(text, {}),
              HasSubstr("take.txt: does not say all that is needed: expected --rate (frames a "
                        "second), --unit (m, cm or mm), --up (the axis"));
  TakeFileOptions options = InMetres();
  options.facts.frame_rate = 120.0;
  EXPECT_THAT(ErrorOf("a,b\n1,2\n", options),
              HasSubstr("take.txt: line 1: expected C3D, TRC, an export of OptiTrack Motive, Vicon "
                        "Nexus or Qualisys, or a table that begins with 'frame,left_x"));
  EXPECT_THAT(ErrorOf("", options), HasSubstr("take.txt"));
  EXPECT_THAT(ErrorOf(With(text, "m1_y", "m1_x"), options),
              HasSubstr("take.txt: line 1, column 6: marker 'm1' has two columns x"));
  EXPECT_THAT(ErrorOf(With(text, "m1_y", "other"), options),
              HasSubstr("take.txt: line 1: marker 'm1' has no column Y"));
  EXPECT_THAT(ErrorOf("frame,a_x,a_y,a_z\n0,1,2,3\n2000000,1,2,3\n", options),
              HasSubstr("take.txt: line 3: expected at most 1000000 frames"));
  EXPECT_THAT(ErrorOf("time,a_x,a_y,a_z\n0,1,2,3\n1,1,2,3\n2.5,1,2,3\n3.5,1,2,3\n", InMetres()),
              HasSubstr("line 4: Time: expected frames at 1 Hz from 0 s on, found 2.5 s"));
  EXPECT_THAT(ErrorOf("time,a_x,a_y,a_z\n0,1,2,3\n0,1,2,3\n", InMetres()),
              HasSubstr("line 3, column 1: Time: expected more than 0, found 0"));
  options.facts.frame_rate = 1e9;
  EXPECT_THAT(ErrorOf(text, options), HasSubstr("frame rate: expected 0.01 to 100000 Hz"));
  options.facts.frame_rate = 120.0;
  options.facts.up = "w";
  EXPECT_THAT(ErrorOf(text, options), HasSubstr("--up: expected x, y, z, -x, -y or -z, found 'w'"));
}

TEST_F(TakeFile, BadRowsAreFramesWithoutMarkers) {
  TakeFileOptions options = WithUp();
  options.skip_bad_rows = true;
  const MarkerTake take = LooseSheet();
  for (const bool has_columns : {false, true}) {
    const std::string text = Qualisys(take, has_columns, "");
    const size_t line = text.find(has_columns ? "\n40\t" : "\n", text.size() / 2);
    const size_t at = text.find('.', has_columns ? text.find('\t', line + 5) : line);
    std::string broken = text;
    broken[at] = '`';
    const MarkerTake read = Read(broken, options);
    ASSERT_EQ(read.num_frames(), take.num_frames());
    int lost = 0;
    for (const auto& position : read.markers[0].positions) lost += position ? 0 : 1;
    EXPECT_EQ(lost, 1);
    EXPECT_THAT(notes_, ElementsAre(HasSubstr("1 rows are skipped, the first: ")));
  }
}

// Rigid bodies are found in any format, by their markers' prefix.
TEST_F(TakeFile, HasRigidBodies) {
  MarkerTake take = LooseSheet();
  for (int i = 0; i < 3; ++i) {
    take.markers.push_back(
        {fmt::format("Bar:{}", i),
         HandleDescription::Path(take.num_frames(), Eigen::Vector3d(0.1 * i, 0.5, 0.1 * i * i))});
  }
  const MarkerTake read = Read(Trc(take));
  ASSERT_EQ(read.bodies.size(), 1u);
  EXPECT_EQ(read.bodies[0].name, "Bar");
  EXPECT_EQ(read.bodies[0].markers.size(), 3u);
  EXPECT_EQ(read.markers.size(), 4u);
}

}  // namespace
}  // namespace clothfit
