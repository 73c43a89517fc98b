// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Faults as displacements of what is seen, and recordings put right.
#include "fitting/diagnosis/fitted/faults.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <tuple>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>

namespace clothfit {
namespace {

constexpr const char* kAxisNames[] = {"x", "y", "z"};
constexpr const char* kClothAxisNames[] = {"u", "v"};

void AddCamera(const Scene& scene, const FitConfig& config, int camera,
               std::vector<Fault>* faults) {
  const std::string name = "camera " + scene.recording.cameras[camera].name;
  const auto add = [&](Fault::Kind kind, const std::string& part, const std::string& unit, int axis,
                       const std::string& suffix, double tolerated, double typical) {
    const std::string group = name + ": " + part;
    faults->push_back({kind, group, group + suffix, unit, camera, axis, tolerated, typical});
  };
  for (int k = 0; k < 3; ++k) {
    add(Fault::Kind::kCameraShift, "pose", "m", k, fmt::format(" shift {}", kAxisNames[k]), 3e-3,
        3e-4);
  }
  for (int k = 0; k < 3; ++k) {
    add(Fault::Kind::kCameraTurn, "pose", "rad", k, fmt::format(" turn {}", kAxisNames[k]), 3e-3,
        2e-4);
  }
  add(Fault::Kind::kCameraClock, "clock", "s", 0, "", 5e-3, 3e-4);
  add(Fault::Kind::kCameraScale, "scale", "1", 0, "", 3e-3, 3e-4);
  if (config.FitsSilhouettes()) add(Fault::Kind::kMaskBias, "fat mask", "px", 0, "", 1.0, 0.1);
}

void AddMarkers(const Scene& scene, std::vector<Fault>* faults) {
  for (int k = 0; k < 3; ++k) {
    faults->push_back({Fault::Kind::kMarkerShift, "markers: place",
                       fmt::format("markers: place {}", kAxisNames[k]), "m", -1, k, 3e-3, 2e-4});
  }
  faults->push_back(
      {Fault::Kind::kMarkerScale, "markers: scale", "markers: scale", "1", -1, 0, 3e-3, 2e-4});
  faults->push_back(
      {Fault::Kind::kMarkerClock, "markers: clock", "markers: clock", "s", -1, 0, 5e-3, 2e-4});
  for (int k = 0; k < 2; ++k) {
    faults->push_back({Fault::Kind::kMarkerLayout, "markers: layout",
                       fmt::format("markers: layout {}", kClothAxisNames[k]), "m", -1, k, 1e-3,
                       3e-4});
  }
  std::set<int> ids;
  for (const MarkerObservation& m : scene.markers) ids.insert(m.id);
  for (const int id : ids) {
    for (int k = 0; k < 2; ++k) {
      const std::string name = fmt::format("marker {}: offset {}", id, kClothAxisNames[k]);
      faults->push_back(
          {Fault::Kind::kMarkerOffset, "marker offsets", name, "m", id, k, 2e-3, 3e-4});
    }
  }
}

// The middle of all markers over time.
Eigen::Vector3d MarkerCentre(const Recording& recording) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Marker& m : recording.markers) sum += m.position;
  return sum / std::max<double>(1.0, static_cast<double>(recording.markers.size()));
}

bool IsOnCloth(Fault::Kind kind) {
  return kind == Fault::Kind::kMarkerLayout || kind == Fault::Kind::kMarkerOffset;
}

// How every particle would have to move (3N, m a unit of the fault) for the residuals to change as
// they do when the fault is put into the prediction.
Eigen::VectorXd EquivalentMotion(const Scene& scene, const Fault& fault, const State& state) {
  const Eigen::Index particles = state.x.size() / 3;
  Eigen::VectorXd motion = Eigen::VectorXd::Zero(state.x.size());
  const auto each = [&](const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& move) {
    for (Eigen::Index i = 0; i < particles; ++i)
      motion.segment<3>(3 * i) = move(state.x.segment<3>(3 * i));
  };
  const Eigen::Vector3d axis = Eigen::Vector3d::Unit(fault.axis);
  switch (fault.kind) {
    case Fault::Kind::kCameraShift:
      each([&](const Eigen::Vector3d&) -> Eigen::Vector3d { return -axis; });
      break;
    case Fault::Kind::kCameraTurn: {
      const Eigen::Vector3d centre = CameraCentre(scene.recording.cameras[fault.source]);
      each([&](const Eigen::Vector3d& x) -> Eigen::Vector3d { return -axis.cross(x - centre); });
      break;
    }
    case Fault::Kind::kCameraScale: {
      // Nearer by a share of its depth, a point is seen larger by that share.
      const Camera& camera = scene.recording.cameras[fault.source];
      const Eigen::Vector3d forward = camera.camera_from_world_rotation.row(2).transpose();
      each([&](const Eigen::Vector3d& x) -> Eigen::Vector3d {
        return -CameraFromWorld<double>(camera, x).z() * forward;
      });
      break;
    }
    case Fault::Kind::kCameraClock:
    case Fault::Kind::kMarkerClock:
      motion = state.v;
      break;
    case Fault::Kind::kMarkerShift:
      each([&](const Eigen::Vector3d&) -> Eigen::Vector3d { return axis; });
      break;
    case Fault::Kind::kMarkerScale: {
      const Eigen::Vector3d centre = MarkerCentre(scene.recording);
      each([&](const Eigen::Vector3d& x) -> Eigen::Vector3d { return x - centre; });
      break;
    }
    case Fault::Kind::kMarkerLayout:
    case Fault::Kind::kMarkerOffset:
    case Fault::Kind::kMaskBias:
      break;
  }
  return motion;
}

// d position / d (u or v) of the triangle that a point lies in.
Eigen::Vector3d Tangent(const ClothMesh& mesh, const SurfacePoint& point, int axis,
                        const Eigen::VectorXd& x) {
  Eigen::Matrix2d edges;
  Eigen::Matrix<double, 3, 2> spans;
  for (int k = 0; k < 2; ++k) {
    edges.col(k) = mesh.uv[point.nodes[k + 1]] - mesh.uv[point.nodes[0]];
    spans.col(k) = x.segment<3>(3 * point.nodes[k + 1]) - x.segment<3>(3 * point.nodes[0]);
  }
  return (spans * edges.inverse()).col(axis);
}

// The rows that a fault can move.
bool Concerns(const Fault& fault, const ResidualSource& row) {
  const bool is_marker = row.kind == ResidualSource::Kind::kMarker;
  if (fault.kind == Fault::Kind::kMarkerOffset) return is_marker && row.source == fault.source;
  if (fault.kind == Fault::Kind::kMaskBias)
    return row.kind == ResidualSource::Kind::kOutline && row.source == fault.source;
  if (IsOfMarkers(fault.kind)) return is_marker;
  return !is_marker && row.source == fault.source;
}

}  // namespace

bool IsOfMarkers(Fault::Kind kind) {
  return kind == Fault::Kind::kMarkerShift || kind == Fault::Kind::kMarkerScale ||
         kind == Fault::Kind::kMarkerClock || IsOnCloth(kind);
}

bool ShowsInTracks(const Fault& fault) {
  return fault.kind == Fault::Kind::kCameraShift || fault.kind == Fault::Kind::kCameraTurn ||
         fault.kind == Fault::Kind::kCameraClock || fault.kind == Fault::Kind::kCameraScale;
}

double LargestSigma(const Fault& fault) {
  constexpr double kOfTolerated = 2.0;
  return kOfTolerated * fault.tolerated;
}

std::vector<Fault> ListFaults(const Scene& scene, const FitConfig& config) {
  std::vector<Fault> faults;
  std::set<int> cameras;
  for (const TrackObservation& t : scene.tracks) cameras.insert(t.camera);
  if (scene.silhouettes) {
    for (const SilhouetteObservation& s : scene.silhouettes->observations) cameras.insert(s.camera);
  }
  for (const int camera : cameras) AddCamera(scene, config, camera, &faults);
  if (!scene.markers.empty()) AddMarkers(scene, &faults);
  return faults;
}

std::vector<ResidualSource> SourcesOfFrame(const Scene& scene, int frame) {
  using Kind = ResidualSource::Kind;
  std::vector<ResidualSource> sources;
  if (!scene.is_fitted[frame]) return sources;
  const auto before = [](const auto& o, int f) { return o.frame < f; };
  auto m = std::lower_bound(scene.markers.begin(), scene.markers.end(), frame, before);
  for (; m != scene.markers.end() && m->frame == frame; ++m)
    sources.insert(sources.end(), 3, {Kind::kMarker, m->id, m->on_cloth});
  auto t = std::lower_bound(scene.tracks.begin(), scene.tracks.end(), frame, before);
  for (; t != scene.tracks.end() && t->frame == frame; ++t) {
    if (scene.IsFitted(*t))
      sources.insert(sources.end(), 2, {Kind::kTrack, t->camera, t->on_cloth});
  }
  if (!scene.silhouettes) return sources;
  const auto& all = scene.silhouettes->observations;
  auto s = std::lower_bound(all.begin(), all.end(), frame, before);
  for (; s != all.end() && s->frame == frame; ++s) {
    if (!s->field) continue;
    sources.insert(sources.end(), s->outline.size(), {Kind::kOutline, s->camera, {}});
    sources.insert(sources.end(), static_cast<std::size_t>(scene.mesh.num_particles()),
                   {Kind::kParticle, s->camera, {}});
  }
  return sources;
}

RowMajorMatrix FaultColumns(const Scene& scene, const FitConfig& config,
                            const ObservationResiduals& observations,
                            const std::vector<Fault>& faults, int frame, const State& state) {
  const int count = static_cast<int>(faults.size());
  const std::vector<ResidualSource> sources = SourcesOfFrame(scene, frame);
  const auto rows = static_cast<Eigen::Index>(sources.size());
  Eigen::MatrixXd motion(state.x.size(), count);
  for (int i = 0; i < count; ++i) motion.col(i) = EquivalentMotion(scene, faults[i], state);
  Sensitivity moved(state, Eigen::MatrixXd::Zero(0, count));
  moved.SetInitial(motion, Eigen::MatrixXd::Zero(state.x.size(), count));
  Eigen::VectorXd residuals(rows);
  RowMajorMatrix columns(rows, count);
  if (!observations.Evaluate(frame, state, &moved, 0, &residuals, &columns))
    return RowMajorMatrix::Zero(rows, count);
  const double marker_weight = std::sqrt(config.beta) / scene.marker_sigma;
  const double outline_weight = std::sqrt(config.alpha) / scene.silhouette_sigma;
  for (Eigen::Index r = 0; r < rows; ++r) {
    const ResidualSource& source = sources[static_cast<std::size_t>(r)];
    for (int i = 0; i < count; ++i) {
      const Fault& fault = faults[i];
      if (!Concerns(fault, source)) {
        columns(r, i) = 0.0;
      } else if (IsOnCloth(fault.kind)) {
        const Eigen::Vector3d tangent = Tangent(scene.mesh, source.point, fault.axis, state.x);
        columns(r, i) = marker_weight * tangent[r % 3];  // markers come first, three rows each
      } else if (fault.kind == Fault::Kind::kMaskBias) {
        columns(r, i) = -outline_weight;
      }
    }
  }
  return columns;
}

namespace {

// One observed point over time.
using Series = std::map<int, Eigen::VectorXd>;

// Where it would have been seen `shift` frames later, by linear interpolation; as it is where a
// neighbour is missing.
Eigen::VectorXd At(const Series& series, int frame, double shift) {
  const Eigen::VectorXd& here = series.at(frame);
  const auto next = series.find(shift > 0.0 ? frame + 1 : frame - 1);
  if (next == series.end()) return here;
  return here + std::abs(shift) * (next->second - here);
}

void ShiftMarkerClock(double shift, Recording* recording) {
  std::map<int, Series> series;
  for (const Marker& m : recording->markers) series[m.id][m.frame] = m.position;
  for (Marker& m : recording->markers) m.position = At(series[m.id], m.frame, shift);
}

void ShiftCameraClock(int camera, double shift, Recording* recording) {
  std::map<int, Series> series;
  for (const Track& t : recording->tracks) {
    if (t.camera == camera) series[t.id][t.frame] = t.pixel;
  }
  for (Track& t : recording->tracks) {
    if (t.camera == camera) t.pixel = At(series[t.id], t.frame, shift);
  }
}

// Moves a camera's centre (m) and turns it about there (rad), both in the world's axes.
void MovePose(const Eigen::Vector3d& shift, const Eigen::Vector3d& turn, Camera* camera) {
  const Eigen::Vector3d centre = CameraCentre(*camera) + shift;
  const double angle = turn.norm();
  if (angle > 0.0) {
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
    camera->camera_from_world_rotation = camera->camera_from_world_rotation * rotation.transpose();
  }
  camera->camera_from_world_translation = -camera->camera_from_world_rotation * centre;
}

}  // namespace

Recording WithoutFaults(const Recording& recording, const std::vector<Fault>& faults,
                        const Eigen::VectorXd& amounts) {
  Recording result = recording;
  std::map<int, std::pair<Eigen::Vector3d, Eigen::Vector3d>> poses;
  const Eigen::Vector3d centre = MarkerCentre(recording);
  for (std::size_t i = 0; i < faults.size(); ++i) {
    const Fault& fault = faults[i];
    const double amount = amounts[static_cast<Eigen::Index>(i)];
    if (amount == 0.0) continue;
    const auto zero =
        std::make_pair(Eigen::Vector3d::Zero().eval(), Eigen::Vector3d::Zero().eval());
    switch (fault.kind) {
      case Fault::Kind::kCameraShift:
        poses.emplace(fault.source, zero).first->second.first[fault.axis] += amount;
        break;
      case Fault::Kind::kCameraTurn:
        poses.emplace(fault.source, zero).first->second.second[fault.axis] += amount;
        break;
      case Fault::Kind::kCameraScale:
        result.cameras[fault.source].fx *= 1.0 + amount;
        result.cameras[fault.source].fy *= 1.0 + amount;
        break;
      case Fault::Kind::kCameraClock:
        ShiftCameraClock(fault.source, -amount * recording.frame_rate, &result);
        if (!result.files.empty())
          result.files[fault.source].mask_faults.later += amount * recording.frame_rate;
        break;
      case Fault::Kind::kMarkerClock:
        ShiftMarkerClock(-amount * recording.frame_rate, &result);
        break;
      case Fault::Kind::kMarkerShift:
        for (Marker& m : result.markers) m.position[fault.axis] -= amount;
        break;
      case Fault::Kind::kMarkerScale:
        for (Marker& m : result.markers) m.position -= amount * (m.position - centre);
        break;
      case Fault::Kind::kMarkerLayout:
      case Fault::Kind::kMarkerOffset:
        for (Marker& m : result.markers) {
          if (fault.kind == Fault::Kind::kMarkerLayout || m.id == fault.source) {
            m.uv[fault.axis] =
                std::clamp(m.uv[fault.axis] + amount, 0.0, recording.cloth.size[fault.axis]);
          }
        }
        break;
      case Fault::Kind::kMaskBias:
        if (!result.files.empty()) result.files[fault.source].mask_faults.fat += amount;
        break;
    }
  }
  for (const auto& [camera, pose] : poses)
    MovePose(pose.first, pose.second, &result.cameras[camera]);
  return result;
}

}  // namespace clothfit
