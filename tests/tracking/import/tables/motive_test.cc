// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/support/motive_file.h"
#include "tests/support/test_folder.h"
#include "tracking/import/take/file.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

// As Motive exports a rigid body beside a labelled and an unlabelled marker, which is lost once.
const char* const kExport =
    "Format Version,1.25,Take Name,\"a, b\",Take Notes,,Capture Frame Rate,240.000000,"
    "Export Frame Rate,120.000000,Rotation Type,Quaternion,Length Units,Millimeters,"
    "Coordinate Space,Global\n"
    "\n"
    ",Type,Rigid Body,Rigid Body,Rigid Body,Rigid Body Marker,Rigid Body Marker,Rigid Body Marker,"
    "Rigid Body Marker,Marker,Marker,Marker,Marker,Marker,Marker\n"
    ",Name,Hand,Hand,Hand,Hand:Marker 001,Hand:Marker 001,Hand:Marker 001,Hand:Marker 001,"
    "Cloth:a,Cloth:a,Cloth:a,\"Unlabeled 1020\",\"Unlabeled 1020\",\"Unlabeled 1020\"\n"
    ",ID,1,1,1,2,2,2,2,\"A1\",\"A1\",\"A1\",\"B,2\",\"B,2\",\"B,2\"\n"
    ",Parent,,,,,,,,,,,,,\n"
    ",,Position,Position,Position,Position,Position,Position,Marker Quality,"
    "Position,Position,Position,Position,Position,Position\n"
    "Frame,Time (Seconds),X,Y,Z,X,Y,Z,,X,Y,Z,X,Y,Z\n"
    "10,0.083333,1,2,3,4,5,6,0.9,100,200,300,-1000,1500,20\n"
    "12,0.091667,1,2,3,4,5,6,0.9,101,201,301,,,\n"
    "16,0.108333,1,2,3,4,5,6,0.9,,,,-1001,1501,21\n";

class MotiveFile : public testing::Test {
 protected:
  MarkerTake Read(const std::string& text, const TakeFileOptions& options = {}) {
    notes_.clear();
    return ReadTake(folder_.Write("take.csv", text), options, &notes_);
  }

  // The error after one replacement in the file above.
  std::string ErrorWith(const std::string& from, const std::string& to) {
    const std::string text = With(from, to);
    return InputErrorOf([&] { Read(text); });
  }

  static std::string With(const std::string& from, const std::string& to) {
    std::string text = kExport;
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  }

  TestFolder folder_;
  std::vector<std::string> notes_;
};

TEST_F(MotiveFile, GivesItsMarkersInMetresWithZUp) {
  const MarkerTake take = Read(kExport);
  EXPECT_EQ(take.frame_rate, 120.0);
  ASSERT_EQ(take.num_frames(), 4u);  // every other number of the capture; 14 lacks
  ASSERT_EQ(NamesOf(take), (std::vector<std::string>{"Cloth:a", "Unlabeled 1020"}));
  const HandleDescription::Path& labelled = take.markers[0].positions;
  EXPECT_LT((*labelled[0] - Eigen::Vector3d(0.1, -0.3, 0.2)).norm(), 1e-15);
  EXPECT_LT((*labelled[1] - Eigen::Vector3d(0.101, -0.301, 0.201)).norm(), 1e-15);
  EXPECT_FALSE(labelled[2]);
  EXPECT_FALSE(labelled[3]);
  const HandleDescription::Path& unlabelled = take.markers[1].positions;
  EXPECT_FALSE(unlabelled[1]);
  EXPECT_LT((*unlabelled[3] - Eigen::Vector3d(-1.001, -0.021, 1.501)).norm(), 1e-15);
}

TEST_F(MotiveFile, MayHaveZUp) {
  TakeFileOptions options;
  options.facts.up = "z";
  const MarkerTake take = Read(kExport, options);
  EXPECT_LT((*take.markers[0].positions[0] - Eigen::Vector3d(0.1, 0.2, 0.3)).norm(), 1e-15);
}

TEST_F(MotiveFile, UnitsAreHonoured) {
  const MarkerTake take = BentSheetTake({{0.0, 0.0}, {0.1, 0.02}});
  int checked = 0;
  for (const auto& [units, metres] : {std::pair("Meters", 1.0), std::pair("Centimeters", 0.01),
                                      std::pair("Millimeters", 0.001)}) {
    const MarkerTake read = Read(MotiveCsv(take, units, metres));
    ASSERT_EQ(read.num_frames(), take.num_frames());
    EXPECT_LT((*read.markers[1].positions[7] - *take.markers[1].positions[7]).norm(), 1e-12);
    ++checked;
  }
  EXPECT_EQ(checked, 3);
  EXPECT_THAT(ErrorWith("Millimeters", "Furlongs"),
              HasSubstr("take.csv: line 1: Length Units: expected m, cm or mm, found 'Furlongs'"));
  EXPECT_THAT(ErrorWith("Length Units", "Units"), HasSubstr("'Length Units' is missing"));
}

TEST_F(MotiveFile, MarkersOfRigidBodiesAreNoCloth) {
  const MarkerTake take = Read(kExport);
  ASSERT_EQ(take.bodies.size(), 1u);  // one marker a prefix, such as Cloth:a, is no body
  EXPECT_EQ(take.bodies[0].name, "Hand");
  ASSERT_EQ(take.bodies[0].markers.size(), 1u);
  EXPECT_EQ(take.bodies[0].markers[0].name, "Hand:Marker 001");
  EXPECT_LT((*take.bodies[0].markers[0].positions[0] - Eigen::Vector3d(4e-3, -6e-3, 5e-3)).norm(),
            1e-15);
}

TEST_F(MotiveFile, BadRowsAreSkippedWhereThatIsAskedFor) {
  TakeFileOptions options;
  options.skip_bad_rows = true;
  const MarkerTake take = Read(With(",-1001,1501,21", ",-1001,15`1,21"), options);
  EXPECT_EQ(take.num_frames(), 2u);
  ASSERT_EQ(notes_.size(), 2u);
  EXPECT_THAT(notes_[0], HasSubstr("y is taken for up"));
  EXPECT_THAT(notes_[1], HasSubstr("1 rows are skipped, the first: "));
  EXPECT_THAT(notes_[1], HasSubstr("take.csv: line 11, column 14: Unlabeled 1020 Y: expected"));
}

TEST_F(MotiveFile, RefusesWrongHeaders) {
  EXPECT_THAT(InputErrorOf([&] { Read("frame,a,b,c\n"); }),
              HasSubstr("expected C3D, TRC, an export of OptiTrack Motive"));
  EXPECT_THAT(InputErrorOf([&] { Read(""); }), HasSubstr("take.csv"));
  EXPECT_THAT(InputErrorOf([&] { ReadTake("gone.csv", {}, &notes_); }),
              HasSubstr("gone.csv: no such"));
  EXPECT_THAT(ErrorWith("Export Frame Rate,120.000000", "Export Frame Rate,fast"),
              HasSubstr("Export Frame Rate: expected a number above 0, found 'fast'"));
  EXPECT_THAT(ErrorWith("Frame,Time", "Frames,Time"), HasSubstr("expected a row 'Frame,Time"));
  EXPECT_THAT(ErrorWith(",Name,Hand", ",Label,Hand"), HasSubstr("the row 'Name' is missing"));
  EXPECT_THAT(ErrorWith("X,Y,Z\n10", "X,Y,W\n10"),
              HasSubstr("line 8: marker 'Unlabeled 1020' has no column Z"));
}

TEST_F(MotiveFile, RefusesFilesWithoutMarkers) {
  std::string text = kExport;
  for (size_t at = 0; (at = text.find(",Marker", at)) != std::string::npos;) {
    text.replace(at, 7, ",Bone");
  }
  EXPECT_THAT(InputErrorOf([&] { Read(text); }),
              HasSubstr("expected columns of markers, found Bone, Rigid Body"));
}

TEST_F(MotiveFile, RefusesWrongRows) {
  EXPECT_THAT(ErrorWith(",-1001,1501,21", ",-1001,1501"),
              HasSubstr("take.csv: line 11: expected 15 fields, found 14"));
  EXPECT_THAT(
      ErrorWith(",201,301", ",inf,301"),
      HasSubstr("line 10, column 11: Cloth:a Y: expected a finite number or nothing, found 'inf'"));
  EXPECT_THAT(ErrorWith(",201,301", ",,301"),
              HasSubstr("line 10: Cloth:a: expected X, Y and Z or none of them"));
  EXPECT_THAT(ErrorWith("\n12,", "\n10,"), HasSubstr("Frame: expected more than 10, found 10"));
  EXPECT_THAT(ErrorWith("\n12,", "\nx,"), HasSubstr("Frame: expected an integer, found 'x'"));
  EXPECT_THAT(ErrorWith("16,0.108333", "16,0.208333"),
              HasSubstr("Time: expected 0.108 after 3 frames at 120 Hz, found 0.208"));
}

}  // namespace
}  // namespace clothfit
