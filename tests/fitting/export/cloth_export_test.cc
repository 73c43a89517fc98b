// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A fitted cloth for programs that simulate it themselves: the files are well-formed, and their
// numbers are those of the mapping in docs/material-elsewhere.md.
#include <cmath>
#include <cstdlib>
#include <regex>

#include "fitting/export/blender.h"
#include "fitting/export/mjcf.h"
#include "fitting/export/newton.h"
#include "fitting/export/script_text.h"
#include "tests/support/small_run.h"
#include "tests/support/test_folder.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::Not;

// A cloth of 0.4 m x 0.2 m with 5 x 3 particles that falls, held at one corner.
RunCloth MakeCloth() {
  RunCloth cloth;
  cloth.motion.name = "</mujoco> -- \"'\n\u202e";
  cloth.motion.mesh = MakeGrid({0.4, 0.2}, {5, 3});
  cloth.motion.frame_rate = 25.0;
  cloth.topology = BuildTopology(cloth.motion.mesh);
  cloth.spacing = 0.1;
  for (const Eigen::Vector2d& uv : cloth.motion.mesh.uv)
    cloth.rest.emplace_back(uv.x(), uv.y(), 0.0);
  for (int f = 0; f < 4; ++f) {
    Eigen::VectorXd x(45);
    for (int i = 0; i < 15; ++i)
      x.segment<3>(3 * i) << cloth.rest[static_cast<std::size_t>(i)].head<2>(), 1.0 - 0.01 * f;
    cloth.motion.frames.push_back(x);
  }
  cloth.velocity = Eigen::VectorXd::Zero(45);
  cloth.material = {0.2, 800.0, 2.0, 30.0, 1.0, 2e-5, 1e-6, 0.5, 0.04};
  cloth.ground_height = 0.0;
  cloth.ground_friction = 0.45;
  cloth.pins = {{4, "<left>", 3}};
  cloth.left_out = {"The obstacle </b> --."};
  return cloth;
}

int Count(const std::string& text, const std::string& what) {
  int count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++count;
  return count;
}

// Runs Python on a file; its output goes into the test's own.
bool PythonAccepts(const std::string& arguments) {
  return std::system(("python3 " + arguments).c_str()) == 0;
}

TEST(Mjcf, IsWellFormedAndHasEveryParticle) {
  const TestFolder folder;
  const fs::path file = folder.Write("cloth.xml", ClothAsMjcf(MakeCloth()));
  const fs::path check = folder.Write(
      "check.py",
      "import sys, xml.etree.ElementTree as tree\n"
      "root = tree.parse(sys.argv[1]).getroot()\n"
      "bodies = root.findall('worldbody/body')\n"
      "flex = root.find('deformable/flex')\n"
      "assert len(bodies) == 16 and sum(len(b.findall('joint')) for b in bodies) == 45\n"
      "assert len(flex.get('body').split()) == 15\n"
      "assert len(flex.get('element').split()) == 3 * 16\n"
      "keys = root.findall('keyframe/key')\n"
      "assert [len(k.get('qpos').split()) for k in keys] == [45] * 4\n"
      "assert [len(k.get('mpos').split()) for k in keys] == [3] * 4\n"
      "mass = sum(float(b.find('inertial').get('mass')) for b in bodies if b.get('mocap') is "
      "None)\n"
      "assert abs(mass - 0.2 * 0.4 * 0.2) < 1e-9\n"
      "sheet = flex.find('elasticity')\n"
      "young, t = float(sheet.get('young')), float(sheet.get('thickness'))\n"
      "assert abs(young * t / 4 - 800) < 1e-3 and abs(young * t ** 3 / 16 - 2e-5) < 1e-10\n"
      "assert abs(float(sheet.get('damping')) - 2.0 / 800) < 1e-9\n"
      "assert root.find('equality/connect').get('body1') == 'p4'\n");
  EXPECT_TRUE(PythonAccepts(check.string() + " " + file.string()));
}

TEST(Mjcf, NoNameEndsACommentOrBecomesMarkup) {
  const std::string text = ClothAsMjcf(MakeCloth());
  EXPECT_EQ(Count(text, "</mujoco>"), 1);
  int comments = 0;
  for (std::size_t at = text.find("<!--"); at != std::string::npos; at = text.find("<!--", at)) {
    const std::size_t end = text.find("--", at + 4);
    ASSERT_EQ(text.substr(end, 3), "-->");
    at = end;
    ++comments;
  }
  EXPECT_EQ(comments, 2);
}

TEST(Mjcf, StepsAreShortEnoughForTheStiffestMode) {
  const ClothMaterial material = MakeCloth().material;
  const FlexMaterial flex = MaterialForMujoco(material, 0.1);
  const double mass = material.density * 0.1 * 0.1;
  EXPECT_LT(flex.timestep, 2.0 / std::sqrt(8.0 * material.stretch / mass));
  EXPECT_LT(flex.timestep, 2.0 * mass / (8.0 * material.stretch_damping));
}

TEST(Scripts, ArePythonWhateverTheNames) {
  const TestFolder folder;
  int checked = 0;
  for (const auto& [name, text] : {std::pair{"blender.py", ClothAsBlenderScript(MakeCloth())},
                                   std::pair{"newton.py", ClothAsNewtonScript(MakeCloth())}}) {
    const fs::path file = folder.Write(name, text);
    EXPECT_TRUE(PythonAccepts("-m py_compile " + file.string())) << name;
    EXPECT_FALSE(std::regex_search(text, std::regex("@[A-Z_]+@"))) << name;
    EXPECT_THAT(text, HasSubstr("# - The obstacle </b> --.")) << name;
    EXPECT_THAT(text, Not(HasSubstr("\u202e"))) << name;
    ++checked;
  }
  EXPECT_EQ(checked, 2);
}

// Each of these is derived in docs/material-elsewhere.md.
TEST(Blender, HasTheFittedMaterialInItsOwnUnits) {
  const RunCloth cloth = MakeCloth();
  const BlenderCloth blender = ClothForBlender(cloth);
  const double unit = std::sqrt(1000.0);
  EXPECT_NEAR(15.0 * blender.mass, 0.2 * 0.4 * 0.2, 1e-12);
  // stiffness / mean length of a spring, in a unit of force of 1000 N
  EXPECT_DOUBLE_EQ(1000.0 * blender.tension / 0.1, 800.0);
  EXPECT_DOUBLE_EQ(unit * blender.tension_damping, 2.0);
  EXPECT_DOUBLE_EQ(1000.0 * blender.shear / 0.1, 2.0 * 30.0);
  // A fold of length h by an angle: stiffness h angle / 10 at h / 2 against B angle; damping by the
  // speed h / 2 there.
  EXPECT_DOUBLE_EQ(1000.0 * blender.bending * 0.1 * 0.1 * 0.1 / 2.0, 2e-5);
  EXPECT_DOUBLE_EQ(unit * blender.bending_damping * 0.1 * 0.1 / 4.0, 1e-6);
  EXPECT_DOUBLE_EQ(unit * 0.01 * blender.air_damping, 0.04 * 0.4 * 0.2 / 15.0);
  EXPECT_DOUBLE_EQ(blender.friction, 45.0);
  EXPECT_DOUBLE_EQ(blender.time_scale / unit, 1.0 / 25.0);
  const std::string text = ClothAsBlenderScript(cloth);
  EXPECT_THAT(text, HasSubstr("FACES = [(0, 1, 6, 5), "));
  EXPECT_THAT(text, HasSubstr("    4: [(0.4, 0, 1), (0.4, 0, 0.99), "));
}

TEST(Newton, HasTheFittedMaterialInItsOwnUnits) {
  const RunCloth cloth = MakeCloth();
  const NewtonCloth newton = ClothForNewton(cloth);
  const double mu = newton.tri_ke, lambda = newton.tri_ka;
  EXPECT_DOUBLE_EQ(4.0 * mu * (mu + lambda) / (2.0 * mu + lambda), 800.0);
  EXPECT_DOUBLE_EQ(4.0 * newton.tri_kd, 2.0);
  // 1/2 edge_ke length angle^2 is the energy of a plate, 1/2 B (angle / h)^2, over length x h,
  // times the share of a grid's side.
  EXPECT_DOUBLE_EQ(newton.edge_ke * 0.1, 4.0 / 3.0 * 2e-5);
  EXPECT_DOUBLE_EQ(newton.edge_kd * 0.1, 4.0 / 3.0 * 1e-6);
  const std::string text = ClothAsNewtonScript(cloth);
  const std::string springs = text.substr(text.find("\nSPRINGS = ["));
  EXPECT_EQ(Count(springs.substr(0, springs.find(")]")), "("),
            static_cast<int>(cloth.topology.structural.size() + cloth.topology.shear.size()));
}

// A sheet that moves along its normal with speed v: k_n v^3 / (1 + k_f v^2) by v^2; along itself
// k_t.
TEST(LinearDrag, TakesAsMuchEnergyAsTheFittedOne) {
  RunMotion motion = MakeCloth().motion;  // 0.01 m a frame at 25 Hz, along the normal
  EXPECT_NEAR(LinearDrag(motion, 0.5, 2.0, 0.03), 0.5 * 0.25 / (1.0 + 2.0 * 0.0625), 1e-9);
  for (std::size_t f = 0; f < motion.frames.size(); ++f) {
    motion.frames[f] = motion.frames[0];
    for (Eigen::Index i = 0; i < 45; i += 3) motion.frames[f][i] += 0.01 * static_cast<double>(f);
  }
  EXPECT_NEAR(LinearDrag(motion, 0.5, 2.0, 0.03), 0.03, 1e-9);
}

TEST(FillIn, ReplacesWhatItKnowsOnce) {
  EXPECT_EQ(FillIn("@A@ @B@ a@b", {{"A", "@B@"}, {"B", "2"}}), "@B@ 2 a@b");
}

TEST(RunCloth, HoldsWhatTheFitFound) {
  const TestFolder folder;
  const RunFolder run = RunFolder::Open(MakeSmallRun(folder.path()));
  const RunCloth cloth = ReadRunCloth(run);
  const std::string yaml = ReadTextFile(run.path() / "parameters.yaml");
  const std::regex line("\nstretch\\.stiffness: \\{value: ([^,]+),");
  std::smatch match;
  ASSERT_TRUE(std::regex_search(yaml, match, line));
  EXPECT_NEAR(cloth.material.stretch, std::stod(match[1]), 1e-9 * cloth.material.stretch);
  EXPECT_EQ(cloth.rest.size(), 25u);
  ASSERT_EQ(cloth.pins.size(), 2u);  // two corners, each a particle
  EXPECT_EQ(cloth.pins[0].last_frame, 11);
  EXPECT_GT(cloth.material.drag_linear, 0.0);
  EXPECT_THAT(cloth.left_out, testing::ElementsAre(testing::HasSubstr("buckling")));
}

}  // namespace
}  // namespace clothfit
