// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// OBJ files: there and back, and every way of getting one wrong.
#include "autodiff_sim/mesh/obj_file.h"

#include <cstdio>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/error.h"
#include "tests/support/scenes.h"

namespace clothfit {
namespace {

class ObjFile : public ::testing::Test {
 protected:
  ObjFile()
      : path_(::testing::TempDir() + "clothfit_" +
              ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".obj") {}
  ~ObjFile() override { std::remove(path_.c_str()); }

  ObjCloth Read(const std::string& text) {
    std::ofstream(path_) << text;
    return ReadObj(path_);
  }

  // The error's text after the file's path.
  std::string Refusal(const std::string& text) {
    try {
      Read(text);
    } catch (const InputError& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.find(path_), 0u) << what;
      EXPECT_EQ(what.find('\n'), std::string::npos) << what;
      return what.substr(std::min(what.size(), path_.size()));
    }
    return {};
  }

  std::string path_;
};

constexpr char kSquare[] =
    "v 0 0 1\nv 1 0 1\nv 1 0 2\nv 0 0 2\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

TEST_F(ObjFile, ThereAndBack) {
  const ClothMesh mesh = MakeGrid({0.5, 0.25}, {4, 3});
  const Eigen::VectorXd x =
      LayFlat(mesh, {0.1, 0.2, 0.3}, Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ());
  std::string text = "# a cloth\no cloth\n";
  char line[200];
  for (int i = 0; i < mesh.num_particles(); ++i) {
    std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\nvt %.17g %.17g\n", x[3 * i],
                  x[3 * i + 1], x[3 * i + 2], mesh.uv[i].x(), mesh.uv[i].y());
    text += line;
  }
  for (const std::array<int, 3>& t : mesh.triangles) {
    std::snprintf(line, sizeof line, "f %d/%d %d/%d/1 %d/%d\n", t[0] + 1, t[0] + 1, t[1] + 1,
                  t[1] + 1, t[2] + 1, t[2] + 1);
    text += line;
  }
  const ObjCloth cloth = Read(text);
  ASSERT_EQ(cloth.mesh.num_particles(), mesh.num_particles());
  ASSERT_EQ(cloth.mesh.triangles.size(), mesh.triangles.size());
  // Particles are numbered as the faces first name them; triangle by triangle they are the same.
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int read = cloth.mesh.triangles[t][k], original = mesh.triangles[t][k];
      EXPECT_EQ(cloth.mesh.uv[read], mesh.uv[original]);
      EXPECT_EQ(cloth.positions[read], Eigen::Vector3d(x.segment<3>(3 * original)));
    }
  }
}

TEST_F(ObjFile, FansQuadsAndCountsBack) {
  const ObjCloth cloth = Read(std::string(kSquare) + "f -4/-4 -3/-3 -2/-2 -1/-1\n");
  EXPECT_EQ(cloth.mesh.num_particles(), 4);
  EXPECT_EQ(cloth.mesh.triangles.size(), 2u);
  EXPECT_EQ(cloth.positions[2], Eigen::Vector3d(1.0, 0.0, 2.0));
}

TEST_F(ObjFile, ReadsLinesOfWindows) {
  const ObjCloth cloth = Read(
      "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nvt 0 0\r\nvt 1 0\r\nvt 0 1\r\n"
      "f 1/1 2/2 3/3\r\n");
  EXPECT_EQ(cloth.mesh.triangles.size(), 1u);
}

TEST_F(ObjFile, SaysWhatIsWrongAndWhere) {
  const std::string square = kSquare;  // 8 lines
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", ": the mesh has no triangle"},
      {"v 0 0\n", ":1: expected 3 finite numbers"},
      {"v 0 nan 0\n", ":1: expected 3 finite numbers"},
      {"v 0 1e999 0\n", ":1: expected 3 finite numbers"},
      {"v 0 a 0\n", ":1: expected 3 finite numbers"},
      {square + "vt 1\n", ":9: expected 2 finite numbers"},
      {square + "f 1/1 2/2\n", ":9: a face needs at least 3 corners"},
      {square + "f 1 2 3\n", ":9: corner '1' has no vt"},
      {square + "f 1//1 2//1 3//1\n", ":9: corner '1//1' has no vt"},
      {square + "f 1/1 2/2 5/3\n", ":9: index 5: expected 1 to 4"},
      {square + "f 1/1 2/2 0/3\n", ":9: index 0: expected 1 to 4"},
      {square + "f 1/1 2/2 3/-5\n", ":9: index -5: expected 1 to 4"},
      {square + "f 1/1 2/2 x/3\n", ":9: 'x': expected"},
      {square + "f 1/1 2/2 3x/3\n", ":9: '3x': expected"},
      {square + "f 1/1 2/2 99999999999/3\n", ":9: "},
      {square + "f 1/1 3/3 2/2\n", ": triangle 1: flipped"},
  };
  for (const auto& [text, start] : cases) {
    EXPECT_THAT(Refusal(text), ::testing::StartsWith(start)) << text;
  }
  EXPECT_THAT(Refusal(square + "f 1/1 2/2 3/3\nf 1/1 4/4 3/3\n"), ::testing::HasSubstr("flipped"));
}

// A vertex of the surface that no face uses is no particle; one with two vt is a seam.
TEST_F(ObjFile, TakesOnlyWhatFacesUse) {
  const ObjCloth unused = Read(std::string("v 9 9 9\nvt 9 9\n") + kSquare + "f 2/2 3/3 4/4\n");
  EXPECT_EQ(unused.mesh.num_particles(), 3);
  const ObjCloth seam =
      Read(std::string(kSquare) + "vt 2 0\nvt 2 1\nf 1/1 2/2 3/3\nf 2/5 2/6 4/4\n");
  EXPECT_EQ(seam.mesh.num_particles(), 6);
}

TEST_F(ObjFile, NeedsAFile) {
  try {
    ReadObj("/no/such/cloth.obj");
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::StartsWith("/no/such/cloth.obj: no such file"));
  }
}

}  // namespace
}  // namespace clothfit
