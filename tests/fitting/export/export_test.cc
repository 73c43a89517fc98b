// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Files for other programs, read back as those read them.
#include "fitting/export/export.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <sstream>

#include <nlohmann/json.hpp>
#include <opencv2/videoio.hpp>

#include "autodiff_sim/mesh/obj_file.h"
#include "fitting/export/gltf.h"
#include "fitting/export/mesh_files.h"
#include "fitting/export/point_cache.h"
#include "fitting/export/usd.h"
#include "fitting/files/npy_file.h"
#include "tests/support/small_run.h"
#include "tests/support/test_folder.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/csv.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

// A value at a byte of a file; `is_big`: its most significant byte first.
template <class T>
T ValueAt(const std::string& bytes, std::size_t at, bool is_big = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, bytes.data() + at, sizeof(T));
  if (is_big) std::reverse(raw, raw + sizeof(T));
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

RunMotion MakeMotion() {
  RunMotion motion;
  motion.name = "small";
  motion.mesh = MakeGrid({0.4, 0.2}, {3, 2});
  motion.frame_rate = 25.0;
  for (int f = 0; f < 4; ++f) {
    Eigen::VectorXd x(18);
    for (int i = 0; i < 6; ++i) {
      x.segment<3>(3 * i) << motion.mesh.uv[i].x(), motion.mesh.uv[i].y() + 0.1 * f, 1.0 + 0.01 * f;
    }
    motion.frames.push_back(x);
  }
  return motion;
}

TEST(PointCache, Pc2HasItsHeaderAndAllPlaces) {
  const RunMotion motion = MakeMotion();
  const std::string bytes = MotionAsPc2(motion);
  ASSERT_EQ(bytes.size(), 32u + 4u * 4u * 18u);
  EXPECT_EQ(bytes.substr(0, 12), std::string("POINTCACHE2\0", 12));
  EXPECT_EQ(ValueAt<std::int32_t>(bytes, 12), 1);
  EXPECT_EQ(ValueAt<std::int32_t>(bytes, 16), 6);
  EXPECT_EQ(ValueAt<float>(bytes, 24), 1.0F);
  EXPECT_EQ(ValueAt<std::int32_t>(bytes, 28), 4);
  for (std::size_t i = 0; i < 72; ++i) {
    EXPECT_EQ(ValueAt<float>(bytes, 32 + 4 * i),
              static_cast<float>(motion.frames[i / 18][static_cast<Eigen::Index>(i % 18)]));
  }
}

TEST(PointCache, MddIsBigEndianWithTimes) {
  const RunMotion motion = MakeMotion();
  const std::string bytes = MotionAsMdd(motion);
  ASSERT_EQ(bytes.size(), 8u + 4u * 4u + 4u * 4u * 18u);
  EXPECT_EQ(ValueAt<std::int32_t>(bytes, 0, true), 4);
  EXPECT_EQ(ValueAt<std::int32_t>(bytes, 4, true), 6);
  EXPECT_EQ(ValueAt<float>(bytes, 8 + 4 * 3, true), static_cast<float>(3.0 / 25.0));
  EXPECT_EQ(ValueAt<float>(bytes, 24 + 4 * (18 + 1), true),
            static_cast<float>(motion.frames[1][1]));
}

TEST(MeshFiles, ObjReadsBack) {
  const TestFolder folder;
  const RunMotion motion = MakeMotion();
  const fs::path file = folder.Write("frame.obj", FrameAsObj(motion, 2));
  const ObjCloth cloth = ReadObj(file.string());
  ASSERT_EQ(cloth.mesh.num_particles(), 6);
  EXPECT_EQ(cloth.mesh.triangles.size(), motion.mesh.triangles.size());
  for (int i = 0; i < 6; ++i) {  // in an order of their own
    const Eigen::Vector2d& uv = cloth.mesh.uv[i];
    EXPECT_EQ(cloth.positions[i], Eigen::Vector3d(uv.x(), uv.y() + 0.1 * 2, 1.0 + 0.01 * 2));
  }
}

TEST(MeshFiles, PlyHasWhatItsHeaderSays) {
  const RunMotion motion = MakeMotion();
  const std::string bytes = FrameAsPly(motion, 1);
  const std::size_t begin = bytes.find("end_header\n") + 11;
  EXPECT_THAT(bytes.substr(0, begin), HasSubstr("element vertex 6\n"));
  const std::size_t faces = motion.mesh.triangles.size();
  ASSERT_EQ(bytes.size(), begin + 6u * 8u * 4u + faces * 13u);
  EXPECT_EQ(ValueAt<float>(bytes, begin + 4), static_cast<float>(motion.frames[1][1]));
  EXPECT_EQ(ValueAt<float>(bytes, begin + 20), 1.0F);  // the normal of a flat cloth
  EXPECT_EQ(static_cast<int>(bytes[begin + 6u * 8u * 4u]), 3);
}

TEST(MeshFiles, CsvHasARowForEveryParticleAndFrame) {
  const TestFolder folder;
  const RunMotion motion = MakeMotion();
  int rows = 0;
  ReadCsv(folder.Write("motion.csv", MotionAsCsv(motion)),
          {"frame", "time", "particle", "u", "v", "x", "y", "z"}, [&](const CsvRow& row) {
            EXPECT_EQ(row.Number(1), row.Integer(0) / 25.0);
            EXPECT_EQ(
                row.Vector3(5),
                Eigen::Vector3d(motion.frames[row.Integer(0)].segment<3>(3 * row.Integer(2))));
            ++rows;
          });
  EXPECT_EQ(rows, 24);
}

TEST(Gltf, HasATargetForEveryLaterFrame) {
  const std::string bytes = MotionAsGlb(MakeMotion());
  ASSERT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(ValueAt<std::uint32_t>(bytes, 4), 2u);
  EXPECT_EQ(ValueAt<std::uint32_t>(bytes, 8), bytes.size());
  const auto length = ValueAt<std::uint32_t>(bytes, 12);
  const auto gltf = nlohmann::json::parse(bytes.substr(20, length));
  EXPECT_EQ(gltf["meshes"][0]["primitives"][0]["targets"].size(), 3u);
  EXPECT_EQ(gltf["animations"][0]["channels"][0]["target"]["path"], "weights");
  // The offset of frame 3: 0.3 m along y is -z in glTF, 0.03 m along z is y.
  const auto& target = gltf["meshes"][0]["primitives"][0]["targets"][2]["POSITION"];
  const auto& view =
      gltf["bufferViews"][gltf["accessors"][target.get<int>()]["bufferView"].get<int>()];
  const std::size_t at = 28 + length + view["byteOffset"].get<std::size_t>();
  EXPECT_FLOAT_EQ(ValueAt<float>(bytes, at), 0.0F);
  EXPECT_FLOAT_EQ(ValueAt<float>(bytes, at + 4), 0.03F);
  EXPECT_FLOAT_EQ(ValueAt<float>(bytes, at + 8), -0.3F);
}

// The numbers in "key = [...]" or after it in the line that begins with "FRAME: [".
std::vector<double> NumbersIn(const std::string& text, const std::string& after) {
  const std::size_t begin = text.find('[', text.find(after)) + 1;
  std::string list = text.substr(begin, text.find(']', begin) - begin);
  for (char& c : list)
    if (c == '(' || c == ')' || c == ',') c = ' ';
  std::istringstream stream(list);
  return {std::istream_iterator<double>(stream), {}};
}

TEST(Usd, HasASampleForEveryFrame) {
  const RunMotion motion = MakeMotion();
  const std::string text = MotionAsUsda(motion);
  EXPECT_EQ(text.substr(0, 10), "#usda 1.0\n");
  EXPECT_THAT(text, HasSubstr("timeCodesPerSecond = 25\n"));
  EXPECT_THAT(text, HasSubstr("endTimeCode = 3\n"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '{'), std::count(text.begin(), text.end(), '}'));
  EXPECT_EQ(NumbersIn(text, "faceVertexCounts =").size(), motion.mesh.triangles.size());
  const std::vector<double> corners = NumbersIn(text, "faceVertexIndices =");
  ASSERT_EQ(corners.size(), 3 * motion.mesh.triangles.size());
  EXPECT_EQ(corners[1], motion.mesh.triangles[0][1]);
  EXPECT_EQ(NumbersIn(text, "primvars:st =").size(), 12U);
  const std::string points = text.substr(text.find("points.timeSamples"));
  for (int f = 0; f < 4; ++f) {
    const std::vector<double> x = NumbersIn(points, " " + std::to_string(f) + ": [");
    ASSERT_EQ(x.size(), 18U);
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_NEAR(x[i], motion.frames[static_cast<std::size_t>(f)][static_cast<Eigen::Index>(i)],
                  1e-6);
  }
  const std::vector<double> normals = NumbersIn(text.substr(text.find("normals")), " 0: [");
  ASSERT_EQ(normals.size(), 18U);
  EXPECT_EQ(normals[2], 1.0);
}

TEST(Export, WritesEveryFormatOfARun) {
  const TestFolder folder;
  const RunFolder run = RunFolder::Open(MakeSmallRun(folder.path()));
  int checked = 0;
  for (const ExportFormat& format : ExportFormats()) {
    const fs::path output =
        folder.path() / (format.is_sequence ? format.name : format.name + format.extension);
    EXPECT_EQ(ExportRun(run, format.name, {}, output), 12) << format.name;
    EXPECT_TRUE(fs::exists(format.is_sequence ? output / ("000011" + format.extension) : output));
    ++checked;
  }
  EXPECT_EQ(checked, 12);
  EXPECT_EQ(ReadTextFile(folder.path() / "npy.npy"), ReadTextFile(run.path() / "trajectory.npy"));
  // The recording begins flat, at x = u and y = v: triangles and places belong together.
  const ObjCloth first = ReadObj((folder.path() / "obj" / "000000.obj").string());
  ASSERT_EQ(first.mesh.num_particles(), 25);
  for (int i = 0; i < 25; ++i) {
    EXPECT_LT((first.positions[i].head<2>() - first.mesh.uv[i]).norm(), 1e-9);
  }
  cv::VideoCapture video((folder.path() / "video.mp4").string());
  ASSERT_TRUE(video.isOpened());
  EXPECT_EQ(video.get(cv::CAP_PROP_FRAME_COUNT), 12.0);
  EXPECT_EQ(video.get(cv::CAP_PROP_FRAME_WIDTH), 160.0);
}

TEST(Export, SaysWhatIsMissing) {
  const TestFolder folder;
  const RunFolder run = RunFolder::Open(MakeSmallRun(folder.path()));
  const auto error = [&](const std::string& format, const OverlayOptions& options,
                         const fs::path& output) {
    return InputErrorOf([&] { ExportRun(run, format, options, folder.path() / output); });
  };
  EXPECT_THAT(error("video", {{}, "fornt"}, "a.mp4"), HasSubstr("did you mean 'front'?"));
  EXPECT_THAT(error("video", {}, "a.mkv"), HasSubstr("expected a name that ends in .mp4 or .avi"));
  EXPECT_THAT(error("gltf", {}, "none/a.glb"), HasSubstr("none: no such folder"));
  WriteWholeFile(run.path() / "trajectory.npy", PointsAsNpy({Eigen::VectorXd::Zero(30)}));
  EXPECT_THAT(error("gltf", {}, "a.glb"), HasSubstr("has 10 particles; expected 25"));
  fs::remove(run.path() / "trajectory.npy");
  EXPECT_THAT(error("gltf", {}, "a.glb"), HasSubstr("trajectory.npy: is missing"));
}

}  // namespace
}  // namespace clothfit
