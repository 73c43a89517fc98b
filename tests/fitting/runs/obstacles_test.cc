// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Surfaces of obstacles lie where the terms that push the cloth begin to push.
#include "fitting/runs/obstacles.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "autodiff_sim/term/tilted_down.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "tests/support/small_recording.h"

namespace clothfit {
namespace {

class UnseenObstacles : public testing::Test {
 protected:
  static Scene MakeSmallScene() {
    const Recording recording = MakeSmallRecording();
    return MakeScene(recording, DefaultConfig(recording));
  }
  std::vector<ObstacleSurface> Surfaces(const std::map<std::string, double>& parameters) const {
    Eigen::VectorXd values = InitialValues(MakeParameterTable());
    for (const auto& [name, value] : parameters)
      values[RequireParameter(MakeParameterTable(), name)] = value;
    return ObstacleSurfaces(scene_, values, {cloth_});
  }
  ObstacleSurface Only(const std::map<std::string, double>& parameters) const {
    const std::vector<ObstacleSurface> surfaces = Surfaces(parameters);
    EXPECT_EQ(surfaces.size(), 1u);
    return surfaces.at(0);
  }
  // A term that pushes, with its two places.
  static std::map<std::string, double> Between(const std::string& term,
                                               const Eigen::Vector3d& first,
                                               const Eigen::Vector3d& second) {
    return {{term + ".stiffness", 1e4}, {term + ".x1", first.x()},  {term + ".y1", first.y()},
            {term + ".z1", first.z()},  {term + ".x2", second.x()}, {term + ".y2", second.y()},
            {term + ".z2", second.z()}};
  }
  static std::vector<Eigen::Vector3d> Vertices(const ObstacleSurface& surface) {
    const Eigen::VectorXd& x = surface.positions.at(0);
    std::vector<Eigen::Vector3d> vertices;
    for (Eigen::Index i = 0; i < x.size(); i += 3) vertices.emplace_back(x.segment<3>(i));
    return vertices;
  }
  // N times twice the area of each face, outwards.
  static std::vector<Eigen::Vector3d> Normals(const ObstacleSurface& surface) {
    const std::vector<Eigen::Vector3d> x = Vertices(surface);
    std::vector<Eigen::Vector3d> normals;
    for (std::size_t t = 0; t < surface.triangles.size(); t += 3) {
      const auto corner = [&](std::size_t k) {
        return x.at(static_cast<std::size_t>(surface.triangles[t + k]));
      };
      normals.push_back((corner(1) - corner(0)).cross(corner(2) - corner(0)));
    }
    return normals;
  }

  Scene scene_ = MakeSmallScene();
  // Two particles are enough to tell where the cloth is.
  Eigen::VectorXd cloth_ = (Eigen::VectorXd(6) << -0.3, -0.2, 0.5, 0.4, 0.6, 1.1).finished();
};

TEST_F(UnseenObstacles, AreShownOnlyWhereTheyPush) {
  EXPECT_TRUE(Surfaces({}).empty());
  EXPECT_TRUE(Surfaces({{"obstacle_sphere.x", 1.0}}).empty());
  EXPECT_EQ(
      Surfaces({{"obstacle_sphere.stiffness", 1e4}, {"obstacle_plane.stiffness", 1e4}}).size(), 2u);
}

TEST_F(UnseenObstacles, PlaneLiesUnderTheCloth) {
  const double height = 0.3, angle_1 = 0.2, angle_2 = -0.4;
  const ObstacleSurface plane = Only({{"obstacle_plane.stiffness", 1e4},
                                      {"obstacle_plane.height", height},
                                      {"obstacle_plane.angle_1", angle_1},
                                      {"obstacle_plane.angle_2", angle_2}});
  EXPECT_TRUE(plane.is_cut);
  const Eigen::Vector3d down =
      TiltedDown<double>(MakeDownFrame(scene_.world.gravity), angle_1, angle_2);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : Vertices(plane)) {
    EXPECT_NEAR(height + down.dot(x), 0.0, 1e-12);
    box.extend(x);
  }
  for (const Eigen::Vector3d& normal : Normals(plane)) EXPECT_LT(normal.dot(down), 0.0);
  // Where either particle would fall on it is a part of it.
  for (Eigen::Index i = 0; i < cloth_.size(); i += 3) {
    const Eigen::Vector3d x = cloth_.segment<3>(i);
    EXPECT_TRUE(box.contains(x - (height + down.dot(x)) * down)) << x.transpose();
  }
}

TEST_F(UnseenObstacles, TableHasATopAndASide) {
  const Eigen::Vector3d first(0.0, 0.1, 0.7), second(0.1, 0.9, 0.75);
  const ObstacleSurface table = Only(Between("obstacle_table", first, second));
  // As terms/obstacle.h has them.
  const Eigen::Vector3d edge = second - first;
  const Eigen::Vector3d over = edge.cross(Eigen::Vector3d::UnitZ()).normalized();
  const Eigen::Vector3d top = over.cross(edge).normalized();
  int on_top = 0, on_side = 0;
  for (const Eigen::Vector3d& x : Vertices(table)) {
    const double below = (first - x).dot(top), behind = (first - x).dot(over);
    EXPECT_GT(std::min(below, behind), -1e-12);
    EXPECT_NEAR(std::min(below, behind), 0.0, 1e-12);
    on_top += below < 1e-9;
    on_side += behind < 1e-9;
  }
  EXPECT_GT(on_top, 100);
  EXPECT_GT(on_side, 100);
  for (const Eigen::Vector3d& normal : Normals(table))
    EXPECT_NEAR(std::max(normal.dot(top), normal.dot(over)), normal.norm(), 1e-12);
}

TEST_F(UnseenObstacles, BallAndBarAreAsThickAsTheySay) {
  const Eigen::Vector3d middle(0.1, 0.2, 0.3), end(0.9, -0.4, 0.6);
  const ObstacleSurface ball = Only({{"obstacle_sphere.stiffness", 1e4},
                                     {"obstacle_sphere.x", middle.x()},
                                     {"obstacle_sphere.y", middle.y()},
                                     {"obstacle_sphere.z", middle.z()},
                                     {"obstacle_sphere.radius", 0.07}});
  EXPECT_FALSE(ball.is_cut);
  for (const Eigen::Vector3d& x : Vertices(ball)) EXPECT_NEAR((x - middle).norm(), 0.07, 1e-12);
  std::map<std::string, double> of_bar = Between("obstacle_capsule", middle, end);
  of_bar["obstacle_capsule.radius"] = 0.03;
  const ObstacleSurface bar = Only(of_bar);
  double nearest_to_end = 1.0;
  for (const Eigen::Vector3d& x : Vertices(bar)) {
    const Eigen::Vector3d axis = end - middle;
    const double share = std::clamp((x - middle).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
    EXPECT_NEAR((x - middle - share * axis).norm(), 0.03, 1e-12);
    nearest_to_end = std::min(nearest_to_end, (x - end).norm());
  }
  EXPECT_NEAR(nearest_to_end, 0.03, 1e-12);
}

TEST_F(UnseenObstacles, ComeAfterThoseOfTheRecording) {
  Recording recording = MakeSmallRecording();
  ObstacleDescription ball;
  ball.name = "ball";
  ball.shape = BallShape{0.1};
  ball.path = {{}};
  recording.obstacles = {ball};
  scene_ = MakeScene(recording, DefaultConfig(recording));
  const std::vector<ObstacleSurface> surfaces = Surfaces(
      {{"obstacle.growth", 0.02}, {"obstacle.shift_z", 0.5}, {"obstacle_plane.stiffness", 1.0}});
  ASSERT_EQ(surfaces.size(), 2u);
  EXPECT_EQ(surfaces[0].name, "ball");
  EXPECT_EQ(surfaces[0].positions.size(), static_cast<std::size_t>(recording.frame_count));
  for (const Eigen::Vector3d& x : Vertices(surfaces[0]))
    EXPECT_NEAR((x - Eigen::Vector3d(0.0, 0.0, 0.5)).norm(), 0.12, 1e-12);
  EXPECT_EQ(surfaces[1].name, "unseen plane");
}

}  // namespace
}  // namespace clothfit
