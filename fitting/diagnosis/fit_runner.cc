// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/fit_runner.h"

#include <algorithm>
#include <optional>
#include <string>
#include <type_traits>

#include <nlohmann/json.hpp>

#include "fitting/diagnosis/sha256.h"
#include "fitting/whole_file.h"
#include "tracking/text.h"

namespace clothfit {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::json;

constexpr const char* kFormat = "clothfit-fit/1";
constexpr const char* kEnding = ".cbor";

// The members of what is kept, once for both ways.
template <class Visitor>
void VisitMembers(Visitor& visit, Evaluation& e) {
  visit("complete", e.complete);
  visit("frames", e.frames);
  visit("marker_rms", e.marker_rms);
  visit("held_out_marker_rms", e.held_out_marker_rms);
  visit("track_rms", e.track_rms);
  visit("held_out_track_rms", e.held_out_track_rms);
  visit("silhouette_error", e.silhouette_error);
  visit("held_out_silhouette_error", e.held_out_silhouette_error);
}

template <class Visitor>
void VisitMembers(Visitor& visit, ParameterEstimate& e) {
  visit("name", e.name);
  visit("unit", e.unit);
  visit("value", e.value);
  visit("start", e.start);
  visit("free", e.free);
  visit("lower95", e.lower95);
  visit("upper95", e.upper95);
  visit("determined", e.determined);
  visit("at_bound", e.at_bound);
}

template <class Visitor>
void VisitMembers(Visitor& visit, StepReport& s) {
  visit("status", s.status);
  visit("newton_iterations", s.newton_iterations);
  visit("linear_iterations", s.linear_iterations);
  visit("sensitivity_iterations", s.sensitivity_iterations);
  visit("jacobians", s.jacobians);
  visit("factorizations", s.factorizations);
  visit("halvings", s.halvings);
  visit("contact_pairs", s.contact_pairs);
  visit("obstacle_contacts", s.obstacle_contacts);
  visit("most_contact_pairs", s.most_contact_pairs);
  visit("most_obstacle_contacts", s.most_obstacle_contacts);
  visit("limited_iterates", s.limited_iterates);
  visit("pattern_rebuilds", s.pattern_rebuilds);
  visit("blocked_steps", s.blocked_steps);
  visit("intersections", s.intersections);
  visit("handle_work", s.handle_work);
  visit("error", s.error);
}

template <class Visitor>
void VisitMembers(Visitor& visit, FitResult& r) {
  visit("status", r.status);
  visit("theta", r.theta);
  visit("parameters", r.parameters);
  visit("iterations", r.iterations);
  visit("simulations", r.simulations);
  visit("simulated_frames", r.simulated_frames);
  visit("differentiated_frames", r.differentiated_frames);
  visit("seconds", r.seconds);
  visit("cost_before", r.cost_before);
  visit("cost_after", r.cost_after);
  visit("before", r.before);
  visit("after", r.after);
  visit("estimates", r.estimates);
  visit("statements", r.statements);
  visit("noise_factor", r.noise_factor);
  visit("steps", r.steps);
}

template <class T>
constexpr bool kIsPlain = std::is_arithmetic_v<T> || std::is_same_v<T, std::string>;

class Writer {
 public:
  template <class T>
  void operator()(const char* name, T& value) {
    json_[name] = Encode(value);
  }
  template <class T>
  static Json Encode(T& value) {
    if constexpr (kIsPlain<T>) {
      return value;
    } else if constexpr (std::is_enum_v<T>) {
      return static_cast<int>(value);
    } else {
      Writer members;
      VisitMembers(members, value);
      return members.json_;
    }
  }
  static Json Encode(Eigen::VectorXd& vector) {
    return std::vector<double>(vector.begin(), vector.end());
  }
  static Json Encode(std::optional<double>& value) { return value ? Json(*value) : Json(); }
  template <class T>
  static Json Encode(std::vector<T>& values) {
    Json json = Json::array();
    for (T& value : values) json.push_back(Encode(value));
    return json;
  }

 private:
  Json json_;
};

class Reader {
 public:
  explicit Reader(const Json& json) : json_(json) {}
  template <class T>
  void operator()(const char* name, T& value) {
    Decode(json_.at(name), &value);
  }
  template <class T>
  static void Decode(const Json& json, T* value) {
    if constexpr (kIsPlain<T>) {
      json.get_to(*value);
    } else if constexpr (std::is_enum_v<T>) {
      *value = static_cast<T>(json.get<int>());
    } else {
      Reader members(json);
      VisitMembers(members, *value);
    }
  }
  static void Decode(const Json& json, Eigen::VectorXd* vector) {
    const auto numbers = json.get<std::vector<double>>();
    *vector = Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                                static_cast<Eigen::Index>(numbers.size()));
  }
  static void Decode(const Json& json, std::optional<double>* value) {
    if (!json.is_null()) *value = json.get<double>();
  }
  template <class T>
  static void Decode(const Json& json, std::vector<T>* values) {
    for (const Json& one : json) Decode(one, &values->emplace_back());
  }

 private:
  const Json& json_;
};

// CBOR keeps every double as it is, infinite ones too.
std::string ToBytes(FitResult result) {
  Json json = Writer::Encode(result);
  json["format"] = kFormat;
  std::string bytes;
  Json::to_cbor(json, bytes);
  return bytes;
}

std::optional<FitResult> ReadKept(const fs::path& file) {
  if (!fs::exists(file)) return std::nullopt;
  try {
    const Json json = Json::from_cbor(ReadTextFile(file));
    if (json.at("format") != kFormat) return std::nullopt;
    FitResult result;
    Reader::Decode(json, &result);
    return result;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

// All that it is given, as bytes.
class Bytes {
 public:
  void Add(const std::string& text) {
    Add(static_cast<double>(text.size()));
    bytes_ += text;
  }
  void Add(double number) { bytes_.append(reinterpret_cast<const char*>(&number), sizeof(number)); }
  template <class Derived>
  void Add(const Eigen::DenseBase<Derived>& matrix) {
    Add(static_cast<double>(matrix.size()));
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      for (Eigen::Index j = 0; j < matrix.cols(); ++j) Add(static_cast<double>(matrix(i, j)));
    }
  }
  const std::string& get() const { return bytes_; }

 private:
  std::string bytes_;
};

void AddObservations(const Scene& scene, Bytes* bytes) {
  for (const double sigma : {scene.marker_sigma, scene.track_sigma, scene.silhouette_sigma})
    bytes->Add(sigma);
  for (const Camera& camera : scene.recording.cameras) {
    for (const double number : {camera.fx, camera.fy, camera.cx, camera.cy}) bytes->Add(number);
    for (const double number : camera.distortion) bytes->Add(number);
    bytes->Add(camera.camera_from_world_rotation);
    bytes->Add(camera.camera_from_world_translation);
  }
  for (const MarkerObservation& marker : scene.markers) {
    bytes->Add(marker.frame);
    bytes->Add(marker.id);
    bytes->Add(marker.on_cloth.At(scene.mesh.uv));
    bytes->Add(marker.position);
  }
  for (const TrackObservation& track : scene.tracks) {
    bytes->Add(track.frame);
    bytes->Add(track.camera);
    bytes->Add(track.id);
    bytes->Add(track.on_cloth.At(scene.mesh.uv));
    bytes->Add(track.pixel);
  }
  if (!scene.silhouettes) return;
  for (const SilhouetteObservation& seen : scene.silhouettes->observations) {
    bytes->Add(seen.frame);
    bytes->Add(seen.camera);
    bytes->Add(static_cast<double>(seen.mask.Count()));
    for (const Eigen::Vector2d& point : seen.outline) bytes->Add(point);
  }
}

// What else of a recording moves a cloth.
void AddMotion(const Scene& scene, Bytes* bytes) {
  const Recording& recording = scene.recording;
  bytes->Add(recording.frame_rate);
  bytes->Add(recording.gravity);
  bytes->Add(recording.ground_height.value_or(-1e9));
  bytes->Add(scene.initial);
  for (const bool is_fitted : scene.is_fitted) bytes->Add(is_fitted ? 1.0 : 0.0);
  for (const std::string& camera : recording.splits.held_out_cameras) bytes->Add(camera);
  for (const SceneHandle& handle : scene.handles) {
    bytes->Add(handle.name);
    bytes->Add(handle.on_cloth.At(scene.mesh.uv));
    bytes->Add(handle.released_after);
    for (int frame = 0; frame < recording.frame_count; ++frame)
      bytes->Add(handle.path.At(scene.FrameTime(frame)));
  }
  for (const ObstacleDescription& obstacle : recording.obstacles) {
    bytes->Add(obstacle.name);
    for (const ObstacleDescription::Pose& pose : obstacle.path) {
      bytes->Add(pose.position);
      bytes->Add(pose.rotation);
    }
  }
}

}  // namespace

std::string FitKey(const Scene& scene, const FitConfig& config, const FitCheckpoint* from) {
  Bytes bytes;
  bytes.Add(CLOTHFIT_VERSION);
  bytes.Add(ConfigToYaml(config));
  AddObservations(scene, &bytes);
  AddMotion(scene, &bytes);
  if (from != nullptr) {
    bytes.Add(from->coarse ? 1.0 : 0.0);
    bytes.Add(from->next_window);
    bytes.Add(from->theta);
    bytes.Add(from->information);
    bytes.Add(from->mean);
  }
  return Sha256(bytes.get());
}

FitResult FitRunner::Run(const Scene& scene, const FitConfig& config, const FitCheckpoint* from,
                         FitCallbacks callbacks) const {
  callbacks.stop = stop_;
  if (folder_.empty()) return RunFit(scene, config, callbacks, from);
  const fs::path file = folder_ / (FitKey(scene, config, from) + kEnding);
  if (const std::optional<FitResult> kept = ReadKept(file)) return *kept;
  const FitResult result = RunFit(scene, config, callbacks, from);
  if (result.status != FitStatus::kInterrupted && !IsStopped())
    WriteWholeFile(file, ToBytes(result));
  return result;
}

int NumKeptFits(const fs::path& folder) {
  if (!fs::is_directory(folder)) return 0;
  const fs::directory_iterator files(folder);
  return static_cast<int>(std::count_if(begin(files), end(files), [](const fs::directory_entry& f) {
    return f.path().extension() == kEnding;
  }));
}

}  // namespace clothfit
