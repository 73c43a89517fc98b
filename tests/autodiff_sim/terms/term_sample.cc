// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The scenes that force terms are sampled in.
#include "tests/autodiff_sim/terms/term_sample.h"

#include <algorithm>
#include <cmath>

#include "autodiff_sim/contact/closest_offset.h"
#include "autodiff_sim/contact/obstacle_contacts.h"
#include "autodiff_sim/contact/self_contacts.h"
#include "autodiff_sim/terms/parameter_table.h"

namespace clothfit {
namespace {

constexpr double kEdge = 0.02;  // m

Eigen::Vector3d RandomVector(double size, std::mt19937* random) {
  std::uniform_real_distribution<double> one(-size, size);
  const double x = one(*random), y = one(*random), z = one(*random);
  return {x, y, z};
}

// Folds the cloth about the line u = 2 edges by this angle.
void Fold(double angle, const ClothMesh& mesh, Eigen::VectorXd* x) {
  for (int i = 0; i < mesh.num_particles(); ++i) {
    const double beyond = mesh.uv[i].x() - 2.0 * kEdge;
    if (beyond <= 0.0) continue;
    (*x)[3 * i] += beyond * (std::cos(angle) - 1.0);
    (*x)[3 * i + 2] += beyond * std::sin(angle);
  }
}

// Targets at a distance (m) from points of the surface as they lie in space.
StepInputs Targets(const TermScene& scene, double distance, std::mt19937* random) {
  StepInputs inputs;
  std::mt19937 random_rate(20263);
  const std::vector<Eigen::Vector2d> uv = {{0.013, 0.017}, {0.041, 0.033}, {0.02, 0.04}};
  for (const SurfacePoint& on_cloth : LocateOnCloth(scene.mesh, uv)) {
    const Eigen::Vector3d place = on_cloth.At(scene.x);
    const Eigen::Vector3d away = RandomVector(1.0, random).normalized();
    inputs.points.push_back({on_cloth, place + distance * away, RandomVector(1.0, &random_rate)});
    inputs.handles.push_back({on_cloth, place + 0.5 * distance * away});
    const Eigen::Vector3d direction = RandomVector(1.0, random).cross(away).normalized();
    const Eigen::Vector3d on_ray = place + distance * away + 0.7 * direction;
    const RayTarget::Rates rates{RandomVector(1.0, &random_rate).cross(direction),
                                 RandomVector(1.0, &random_rate)};
    inputs.rays.push_back({on_cloth, direction, on_ray.cross(direction), rates});
  }
  inputs.residual_force = {{0.0, 0.0}, {4.0 * kEdge, 3.0 * kEdge}, {3, 2}, {}};
  std::mt19937 random_force(20262);
  for (int node = 0; node < 6; ++node)
    inputs.residual_force.force.push_back(RandomVector(2.0, &random_force));
  return inputs;
}

// m, from the obstacle's surface or the ground.
double Gap(const ObstacleContact& contact, const Eigen::VectorXd& x) {
  FourPoints points = contact.points;
  if (contact.is_ground) return x[3 * contact.nodes[0] + 2] - points[1].z();
  for (int i = 0; i < contact.count; ++i)
    points[contact.first + i] = x.segment<3>(3 * contact.nodes[i]);
  return FindClosestOffset<double>(contact.kind, points, points).offset.norm() - contact.radius;
}

// A ball, a bar and a box that the cloth is about to touch, on the move.
void AddObstacles(TermScene* scene) {
  std::vector<std::shared_ptr<const Obstacle>> bodies;
  const auto add = [&](Obstacle obstacle, const Eigen::Vector3d& place, int particle) {
    RigidPose before, after;
    before.origin_in_world = scene->x.segment<3>(3 * particle) + place;
    after = before;
    before.origin_in_world += Eigen::Vector3d(1e-3, 2e-3, -3e-3);
    after.world_from_body = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1.0, 2.0, 2.0) / 3.0);
    obstacle.path = {before, after};
    obstacle.frame_rate = 100.0;
    bodies.push_back(std::make_shared<Obstacle>(obstacle));
  };
  add(MakeBall(0.01), {0.003, 0.004, 0.015}, 6);
  add(MakeBar(0.01, 0.05), {-0.002, 0.005, 0.014}, 13);
  add(MakeBoxObstacle({0.007, 0.007, 0.007}), {0.004, 0.003, -0.016}, 8);
  ObstacleContacts obstacles(scene->mesh, bodies, scene->world.ground_height);
  obstacles.BeginStep(0.0, 0.01);
  for (const ObstacleContact& contact : obstacles.Find(scene->x, 0.012, 0.001)) {
    // The states of a simulation are outside.
    if (Gap(contact, scene->x) > 4e-4) scene->obstacles.push_back(contact);
  }
}

}  // namespace

std::vector<TermScene> MakeTermScenes() {
  struct Shape {
    const char* name;
    double noise;   // of the positions, edges
    double fold;    // degrees
    double height;  // m, of the cloth above the ground
    double speed, distance;
  };
  // Noise of the heights stays below the contact distance where the cloth touches the ground.
  constexpr std::array<Shape, 9> kShapes = {{{"flat, near", 0.0, 0.0, 0.5, 0.3, 1e-3},
                                             {"wavy, slow", 0.02, 0.0, 0.5, 1e-4, 5e-3},
                                             {"crumpled", 0.25, 0.0, 0.5, 1.0, 0.1},
                                             {"folded by 90 degrees", 0.02, 90.0, 0.3, 0.5, 0.5},
                                             {"folded by -90 degrees", 0.02, -90.0, 0.3, 0.5, 0.02},
                                             {"folded by 175 degrees", 0.01, 175.0, 0.3, 3.0, 0.3},
                                             {"sliding on the ground", 0.02, 0.0, 8e-4, 1.0, 0.05},
                                             {"sticking to it", 0.02, 0.0, 8e-4, 1e-4, 0.01},
                                             {"beneath it", 0.02, 0.0, -3e-3, 0.02, 2e-3}}};
  std::vector<TermScene> scenes;
  std::mt19937 random(20260);
  for (const Shape& shape : kShapes) {
    TermScene scene;
    scene.name = shape.name;
    scene.mesh = MakeGrid({4 * kEdge, 3 * kEdge}, {5, 4});
    scene.topology = BuildTopology(scene.mesh);
    scene.world.ground_height = 0.0;
    scene.speed = shape.speed;
    scene.x = LayFlat(scene.mesh, {0.1, -0.05, shape.height}, Eigen::Vector3d::UnitX(),
                      Eigen::Vector3d::UnitY());
    scene.v.resize(scene.x.size());
    scene.a.resize(scene.x.size());
    scene.start.resize(scene.x.size());
    Fold(shape.fold * M_PI / 180.0, scene.mesh, &scene.x);
    for (int i = 0; i < scene.mesh.num_particles(); ++i) {
      scene.x.segment<3>(3 * i) += RandomVector(shape.noise * kEdge, &random);
      scene.v.segment<3>(3 * i) = RandomVector(shape.speed, &random);
      scene.a.segment<3>(3 * i) = RandomVector(shape.speed, &random);
    }
    std::mt19937 random_start(20261);
    for (int i = 0; i < scene.mesh.num_particles(); ++i) {
      scene.start.segment<3>(3 * i) =
          scene.x.segment<3>(3 * i) + RandomVector(0.05 * kEdge, &random_start);
    }
    scene.inputs = Targets(scene, shape.distance, &random);
    scene.contacts = SelfContacts(scene.mesh).Find(scene.x, 0.012);
    AddObstacles(&scene);
    scenes.push_back(scene);
  }
  return scenes;
}

void RemoveGround(TermScene* scene) {
  scene->world.ground_height.reset();
  std::vector<ObstacleContact>& contacts = scene->obstacles;
  contacts.erase(std::remove_if(contacts.begin(), contacts.end(),
                                [](const ObstacleContact& contact) { return contact.is_ground; }),
                 contacts.end());
}

std::vector<TermScene> MakeBucklingTermScenes() {
  std::vector<TermScene> scenes = MakeTermScenes();
  for (TermScene& scene : scenes) {
    scene.mesh.buckles = true;
    scene.topology = BuildTopology(scene.mesh);
  }
  return scenes;
}

TermScene Moved(const TermScene& scene, const Eigen::Matrix3d& rotation,
                const Eigen::Vector3d& shift) {
  TermScene moved = scene;
  moved.world.gravity = rotation * scene.world.gravity;
  for (int i = 0; i < scene.mesh.num_particles(); ++i) {
    moved.x.segment<3>(3 * i) = rotation * scene.x.segment<3>(3 * i) + shift;
    moved.v.segment<3>(3 * i) = rotation * scene.v.segment<3>(3 * i);
    moved.a.segment<3>(3 * i) = rotation * scene.a.segment<3>(3 * i);
    moved.start.segment<3>(3 * i) = rotation * scene.start.segment<3>(3 * i) + shift;
  }
  for (ObstacleContact& contact : moved.obstacles) {
    for (Eigen::Vector3d& point : contact.points) point = rotation * point + shift;
    for (Eigen::Vector3d& velocity : contact.velocities) velocity = rotation * velocity;
  }
  for (HandleTarget& handle : moved.inputs.handles)
    handle.position = rotation * handle.position + shift;
  for (PointTarget& target : moved.inputs.points) {
    target.position = rotation * target.position + shift;
    if (target.velocity) target.velocity = rotation * *target.velocity;
  }
  for (RayTarget& ray : moved.inputs.rays) {
    ray.direction = rotation * ray.direction;
    ray.moment = rotation * ray.moment + shift.cross(ray.direction);
    if (!ray.rates) continue;
    ray.rates->direction = rotation * ray.rates->direction;
    ray.rates->moment = rotation * ray.rates->moment + shift.cross(ray.rates->direction);
  }
  return moved;
}

double InitialValue(const std::string& name) {
  static const std::vector<NamedParameter> table = MakeParameterTable();
  return table[static_cast<std::size_t>(RequireParameter(table, name))].parameter.initial;
}

double ReadValue(const std::string& name) {
  return name == "grip.compliance" ? 2e-3 : InitialValue(name);
}

double RandomParameter(const Parameter& parameter, const TermScene& scene, std::mt19937* random) {
  const auto between = [random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(*random);
  };
  const auto near_the_cloth = [&](int axis) {
    return scene.x[axis] + between(-2.0 * kEdge, 6.0 * kEdge);
  };
  const bool is_log = parameter.scale == Scale::kLog;
  switch (parameter.meaning) {
    case Meaning::kPlaceX:
      return near_the_cloth(0);
    case Meaning::kPlaceY:
      return near_the_cloth(1);
    case Meaning::kAlongTilt:
    case Meaning::kPlaceZ:
      return scene.x[2] + between(-2.0 * kEdge, 2.0 * kEdge);
    case Meaning::kClothU:
      return between(0.0, 4.0 * kEdge);
    case Meaning::kClothV:
      return between(0.0, 3.0 * kEdge);
    case Meaning::kClothDistance:
      return is_log ? between(kEdge, 3.0 * kEdge) : between(-kEdge, kEdge);
    case Meaning::kTime:
      return is_log ? between(0.5, 2.0) * kSampleTime : between(0.0, kSampleTime);
    default:
      break;
  }
  // Obstacles stay so near to where they are that those in contact are.
  if (parameter.places != Places::kNothing) return between(-1e-4, 1e-4);
  const double share = between(0.05, 0.95);
  return is_log ? parameter.lower * std::pow(parameter.upper / parameter.lower, share)
                : parameter.lower + share * (parameter.upper - parameter.lower);
}

}  // namespace clothfit
