// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/clouds/file.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using Eigen::Vector3d;
using CloudPoints = std::vector<Vector3d>;
using testing::HasSubstr;

const CloudPoints kPoints = {{0.5, -0.25, 1.0}, {2.0, 0.125, -4.0}};  // exact in single precision

CloudPoints Read(const std::string& name, const std::string& text) {
  const TestFolder folder;
  return ReadCloudFile(folder.Write(name, text));
}

std::string ErrorOf(const std::string& name, const std::string& text) {
  return InputErrorOf([&] { Read(name, text); });
}

template <class Number>
std::string Bytes(Number number, bool big = false) {
  std::string bytes(reinterpret_cast<const char*>(&number), sizeof(number));
  if (big) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

// x, y, z in double and single precision, with a colour in between.
std::string BinaryPly(bool big) {
  std::string text = std::string("ply\nformat ") +
                     (big ? "binary_big_endian" : "binary_little_endian") +
                     " 1.0\ncomment made by hand\nelement camera 1\nproperty short a\n"
                     "element vertex 2\nproperty double x\nproperty uchar red\nproperty float y\n"
                     "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                     "end_header\n";
  text += Bytes<std::int16_t>(7, big);
  for (const Vector3d& p : kPoints) {
    text += Bytes(p.x(), big) + Bytes<std::uint8_t>(200, big) +
            Bytes(static_cast<float>(p.y()), big) + Bytes(static_cast<float>(p.z()), big);
  }
  return text + "faces follow";
}

const char* const kTextPly =
    "ply\r\nformat ascii 1.0\r\nobj_info x\r\nelement vertex 3\r\nproperty float z\r\n"
    "property float y\r\nproperty float x\r\nproperty uchar red\r\nelement face 1\r\n"
    "property list uchar int vertex_indices\r\nend_header\r\n"
    "1 -0.25 +0.5 9\r\nnan 0 0 9\r\n-4 0.125 2e0 9\r\n3 0 1 2\r\n";

TEST(ReadCloudFile, ReadsPly) {
  EXPECT_EQ(Read("a.ply", kTextPly), kPoints);  // without the point that is none
  EXPECT_EQ(Read("a.ply", BinaryPly(false)), kPoints);
  EXPECT_EQ(Read("a.ply", BinaryPly(true)), kPoints);
  EXPECT_EQ(Read("a.ply", CloudAsPly(kPoints)), kPoints);
  EXPECT_TRUE(Read("a.ply", CloudAsPly({})).empty());
}

TEST(ReadCloudFile, ReadsPcd) {
  const std::string header =
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z rgb normal\n"
      "SIZE 4 4 4 4 4\nTYPE F F F U F\nCOUNT 1 1 1 1 3\nWIDTH 2\nHEIGHT 1\n"
      "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ";
  EXPECT_EQ(Read("a.pcd", header + "ascii\n0.5 -0.25 1 4294967295 0 0 1\n2 0.125 -4 0 nan 0 0\n"),
            kPoints);
  std::string binary = header + "binary\n";
  for (const Vector3d& p : kPoints) {
    for (int k = 0; k < 3; ++k) binary += Bytes(static_cast<float>(p[k]));
    binary += std::string(16, '\x7f');
  }
  EXPECT_EQ(Read("a.pcd", binary), kPoints);
  EXPECT_THAT(ErrorOf("a.pcd", header + "binary_compressed\n"), HasSubstr("binary_compressed"));
}

TEST(ReadCloudFile, ReadsCsv) {
  EXPECT_EQ(Read("a.csv", "z,x,y\n1,0.5,-0.25\n,,\n-4,2,0.125\n"), kPoints);
}

// Each in one line that names the file and what was expected.
TEST(ReadCloudFile, RefusesWhatIsBroken) {
  const std::string ply = kTextPly;
  const auto changed = [](std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos);
    return text.replace(at, from.size(), to);
  };
  struct Broken {
    std::string name, text, says;
  };
  const std::string binary = BinaryPly(false);
  const std::vector<Broken> all = {
      {"a.ply", "solid", "begins with 'ply'"},
      {"a.ply", "ply\nformat ascii 1.0\n", "header is cut off"},
      {"a.ply", "ply\nend_header\n", "without 'format'"},
      {"a.ply", changed(ply, "ascii", "morse"), "line 2"},
      {"a.ply", changed(ply, "vertex 3", "vertex -3"), "line 4"},
      {"a.ply", changed(ply, "vertex 3", "vertex 99999999999"), "line 4"},
      {"a.ply", changed(ply, "vertex 3", "vertex 9"), "cut off: expected 9 points"},
      {"a.ply", changed(ply, "float y", "float w"), "has no y"},
      {"a.ply", changed(ply, "float y", "quad y"), "line 6"},
      {"a.ply", changed(ply, "-0.25", "O.25"), "line 12: expected a number, found 'O.25'"},
      {"a.ply", changed(ply, "vertex 3", "edge 3"), "no element 'vertex'"},
      {"a.ply", changed(ply, "property float y", "property list uchar int y"), "a list"},
      {"a.ply", binary.substr(0, binary.size() - 30), "cut off"},
      {"a.pcd", "FIELDS x y z\nSIZE 4 4\n", "line 2"},
      {"a.pcd", "FIELDS x y z\nSIZE 4 4 3\nTYPE F F F\nPOINTS 0\nDATA ascii\n", "'z'"},
      {"a.pcd", "FIELDS x y z\nSIZE 4 4 4\nTYPE F F Q\nPOINTS 0\nDATA ascii\n", "'z'"},
      {"a.pcd", "FIELDS x y\nPOINTS 1\nDATA ascii\n1 2\n", "has no z"},
      {"a.pcd", "FIELDS x y z\nPOINTS 1\nDATA ascii\n1 2\n", "line 4: has too few numbers"},
      {"a.pcd", "FIELDS x y z\nPOINTS 2\nDATA ascii\n1 2 3\n", "cut off"},
      {"a.pcd", "solid\n", "header of PCD"},
      {"a.csv", "x,y\n1,2\n", "column 'z'"},
      {"a.csv", "x,y,z\n1,2,three\n", "line 2"},
  };
  for (const Broken& broken : all) {
    const std::string error = ErrorOf(broken.name, broken.text);
    EXPECT_THAT(error, HasSubstr(broken.says)) << broken.text;
    EXPECT_THAT(error, HasSubstr(broken.name));
    EXPECT_EQ(error.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace clothfit
