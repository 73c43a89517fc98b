// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/camera/surface_rays.h"

#include <limits>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace clothfit {
namespace {

// Embree 4 takes what Embree 3 calls a context as an option.
void Intersect(RTCScene scene, RTCRayHit* hit) {
#if RTC_VERSION_MAJOR >= 4
  rtcIntersect1(scene, hit);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, hit);
#endif
}

void FindOccluder(RTCScene scene, RTCRay* ray) {
#if RTC_VERSION_MAJOR >= 4
  rtcOccluded1(scene, ray);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, ray);
#endif
}

RTCRay MakeRay(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double near,
               double far) {
  RTCRay ray;
  const Eigen::Vector3f o = origin.cast<float>(), d = direction.cast<float>();
  ray.org_x = o.x();
  ray.org_y = o.y();
  ray.org_z = o.z();
  ray.dir_x = d.x();
  ray.dir_y = d.y();
  ray.dir_z = d.z();
  ray.tnear = static_cast<float>(near);
  ray.tfar = static_cast<float>(far);
  ray.time = 0.0F;
  ray.mask = std::numeric_limits<unsigned>::max();
  ray.id = 0;
  ray.flags = 0;
  return ray;
}

}  // namespace

struct SurfaceRays::Scene {
  // One thread builds: scenes are small, and the same tree comes out wherever it is built.
  Scene() : device(rtcNewDevice("threads=1")), scene(rtcNewScene(device)) {
    if (device == nullptr) throw std::runtime_error("Embree cannot be started");
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  }
  ~Scene() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  RTCDevice device;
  RTCScene scene;
  RTCGeometry geometry = nullptr;  // owned by the scene once it is attached
};

SurfaceRays::SurfaceRays(std::vector<std::array<int, 3>> triangles)
    : scene_(std::make_unique<Scene>()), triangles_(std::move(triangles)) {}
SurfaceRays::~SurfaceRays() = default;
SurfaceRays::SurfaceRays(SurfaceRays&&) noexcept = default;

void SurfaceRays::MoveTo(const Eigen::VectorXd& x) {
  const bool is_new = scene_->geometry == nullptr || x_.size() != x.size();
  x_ = x;
  if (is_new) {
    if (scene_->geometry != nullptr) rtcDetachGeometry(scene_->scene, 0);
    scene_->geometry = rtcNewGeometry(scene_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* const corners = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(scene_->geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), triangles_.size()));
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k)
        corners[3 * t + k] = static_cast<unsigned>(triangles_[t][k]);
    }
    rtcSetNewGeometryBuffer(scene_->geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                            3 * sizeof(float), static_cast<std::size_t>(x.size() / 3));
  }
  auto* const vertices =
      static_cast<float*>(rtcGetGeometryBufferData(scene_->geometry, RTC_BUFFER_TYPE_VERTEX, 0));
  for (Eigen::Index i = 0; i < x.size(); ++i) vertices[i] = static_cast<float>(x[i]);
  rtcUpdateGeometryBuffer(scene_->geometry, RTC_BUFFER_TYPE_VERTEX, 0);
  rtcCommitGeometry(scene_->geometry);
  if (is_new) {
    rtcAttachGeometryByID(scene_->scene, scene_->geometry, 0);
    rtcReleaseGeometry(scene_->geometry);
  }
  rtcCommitScene(scene_->scene);
}

std::optional<SurfaceHit> SurfaceRays::First(const Eigen::Vector3d& origin,
                                             const Eigen::Vector3d& direction, double near) const {
  if (scene_->geometry == nullptr) return std::nullopt;
  const Eigen::Vector3d unit = direction.normalized();
  RTCRayHit hit;
  hit.ray = MakeRay(origin, unit, near, std::numeric_limits<double>::infinity());
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  Intersect(scene_->scene, &hit);
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  SurfaceHit result;
  result.triangle = static_cast<int>(hit.hit.primID);
  const std::array<int, 3>& nodes = triangles_[hit.hit.primID];
  const Eigen::Vector3d a = x_.segment<3>(3 * nodes[0]);
  const Eigen::Vector3d ab = x_.segment<3>(3 * nodes[1]) - a;
  const Eigen::Vector3d ac = x_.segment<3>(3 * nodes[2]) - a;
  // Moeller and Trumbore 1997, with the triangle known. Edge-on, single precision has to do.
  const Eigen::Vector3d across = unit.cross(ac), from_a = origin - a;
  const double volume = ab.dot(across);
  double u = hit.hit.u, v = hit.hit.v;
  result.distance = hit.ray.tfar;
  if (std::abs(volume) > 1e-9 * ab.norm() * ac.norm()) {
    u = from_a.dot(across) / volume;
    v = unit.dot(from_a.cross(ab)) / volume;
    result.distance = ac.dot(from_a.cross(ab)) / volume;
  }
  result.on_surface.nodes = nodes;
  result.on_surface.weights = {1.0 - u - v, u, v};
  result.normal = ab.cross(ac).normalized();
  return result;
}

bool SurfaceRays::IsBlocked(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                            double margin) const {
  if (scene_->geometry == nullptr) return false;
  const Eigen::Vector3d way = to - from;
  const double length = way.norm();
  if (length <= margin) return false;
  RTCRay ray = MakeRay(from, way / length, 0.0, length - margin);
  FindOccluder(scene_->scene, &ray);
  return ray.tfar < 0.0F;
}

}  // namespace clothfit
