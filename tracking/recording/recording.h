// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A recording: everything that is known about one scene, as plain structs, and its folder on disk.
//
// Units are metres, seconds, kilograms and pixels. (u, v) are cloth coordinates in metres, pixels
// are OpenCV's. Frames are numbered from 0. What is not known is an empty optional. Truth that may
// lie beside a recording is no part of it: see tracking/recording/surface/truth.h.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "tracking/camera/camera.h"
#include "tracking/files/output_file.h"

namespace clothfit {

// Sigmas that are assumed where a recording does not give its own.
inline constexpr double kDefaultMarkerSigma = 0.002;    // m
inline constexpr double kDefaultTrackSigma = 0.5;       // px
inline constexpr double kDefaultSilhouetteSigma = 1.0;  // px
inline constexpr double kDefaultPathSigma = 0.005;      // m
inline constexpr double kDefaultCloudSigma = 0.005;     // m
inline constexpr double kDefaultCloudSpacing = 0.01;    // m

// The cloth lies flat at frame 0: x(u, v) = origin + u * u_axis + v * v_axis.
struct FlatPlacement {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();   // m, world
  Eigen::Vector3d u_axis = Eigen::Vector3d::UnitX();  // unit length, perpendicular to v_axis
  Eigen::Vector3d v_axis = Eigen::Vector3d::UnitY();
};

struct PlacedPoint {
  Eigen::Vector2d uv;        // m, on the cloth
  Eigen::Vector3d position;  // m, world, at frame 0
};

// Some points of the cloth at frame 0, in any order; the rest is interpolated between them.
struct PointPlacement {
  std::vector<PlacedPoint> points;
};

// A triangle mesh (OBJ) whose vertices are the cloth at frame 0 and whose vt are (u, v) in metres.
struct MeshPlacement {
  std::filesystem::path file;  // as it can be opened, not relative to the recording
};

struct ClothDescription {
  Eigen::Vector2d size = Eigen::Vector2d::Ones();              // m along u (warp) and v (weft)
  Eigen::Vector2i resolution = Eigen::Vector2i::Constant(31);  // particles along u and v; a default
                                                               // that the user can override, and
                                                               // without meaning beside a mesh
  std::optional<double> areal_density;                         // kg/m^2
  std::variant<FlatPlacement, PointPlacement, MeshPlacement> initial;
};

// A point of the cloth that something holds.
struct HandleDescription {
  // Where the handle was (m, world), one entry a frame; an entry is empty where that is not known.
  using Path = std::vector<std::optional<Eigen::Vector3d>>;

  std::string name;
  Eigen::Vector2d uv = Eigen::Vector2d::Zero();
  std::optional<Path> path;           // empty: the path is to be fitted, from the initial position
  std::optional<double> path_sigma;   // m; empty: kDefaultPathSigma
  std::optional<int> released_after;  // last frame at which it holds; empty: it holds to the end
};

// A rigid thing that the cloth meets. Each stands about the origin of a frame of its own.
struct BallShape {
  double radius = 0.0;  // m
};
struct BarShape {
  double radius = 0.0;  // m, of its round ends too
  double length = 0.0;  // m, between the middles of its ends, along z
};
struct BoxShape {
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  // m
  double below = 0.0;  // m, by which its sides go on along -z: what stands under a table's top
};
struct MeshShape {
  std::filesystem::path file;  // OBJ, m; as it can be opened, not relative to the recording
};
struct ObstacleDescription {
  struct Pose {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  // m, world, of the frame's origin
    Eigen::Vector3d rotation = Eigen::Vector3d::Zero();  // rad, axis times angle
  };
  std::string name;
  std::variant<BallShape, BarShape, BoxShape, MeshShape> shape;
  std::vector<Pose> path = {Pose()};  // one, at rest, or one a frame
};

// Standard deviations; empty: the default above.
struct NoiseSigmas {
  std::optional<double> marker;      // m
  std::optional<double> layout;      // m along u and v, of markers' places on the cloth; empty: 0
  std::optional<double> track;       // px
  std::optional<double> silhouette;  // px
  std::optional<double> cloud;       // m, of a point's distance from the surface
  // m: points of a cloud that are nearer to each other share their errors, and say as much as one.
  std::optional<double> cloud_spacing;
  std::optional<double> obstacles;  // m, of the obstacles' places and radii, all off alike
};

// What a held-out evaluation must not fit.
struct Splits {
  struct FrameRange {
    int first = 0;
    int last = 0;  // inclusive
  };
  std::optional<FrameRange> held_out_frames;
  std::vector<std::string> held_out_cameras;
};

// A 3D point of the cloth, measured.
struct Marker {
  int frame = 0;
  int id = 0;                // the same id is the same point of the cloth in every frame
  Eigen::Vector2d uv;        // m, on the cloth
  Eigen::Vector3d position;  // m, world
};

// A 2D feature of the cloth, tracked in one camera.
struct Track {
  int frame = 0;
  int camera = 0;         // index into Recording::cameras
  int id = 0;             // the same id and camera is the same point of the cloth in every frame
  Eigen::Vector2d uv;     // m, on the cloth
  Eigen::Vector2d pixel;  // px
};

// What is known to be wrong with a camera's masks, and is put right where they are loaded. No part
// of the format: a diagnosis finds it.
struct MaskFaults {
  double later = 0.0;  // frames, by which they were taken later than said
  double fat = 0.0;    // px, by which they are too fat
  bool operator==(const MaskFaults& other) const {
    return later == other.later && fat == other.fat;
  }
};

// Where the pictures of one camera are. Nothing is opened before
// tracking/recording/pictures/images.h is asked.
struct CameraFiles {
  std::map<int, std::filesystem::path> images;  // by frame; a frame may lack
  std::map<int, std::filesystem::path> masks;   // by frame; 0 = background, 255 = cloth
  std::map<int, std::filesystem::path> depth;   // by frame; 16 bits, see CloudFiles
  MaskFaults mask_faults;
  std::optional<std::filesystem::path> video;  // not looked at where there are images
  std::optional<std::filesystem::path> background;
};

// Where there are points of the surface of which nobody knows where on the cloth they are. Nothing
// is opened before tracking/recording/clouds/clouds.h is asked.
struct CloudFiles {
  std::map<int, std::filesystem::path> files;  // by frame; points in m, world
  std::string camera;  // that saw them, by its name; empty: they show the whole cloth
  // m along a camera's view that one unit of its depth pictures stands for, by its name.
  std::map<std::string, double> depth_scales;
};

// A marker or a track that is off by far more than its noise.
struct Outlier {
  std::variant<Marker, Track> point;
  double off = 0.0;  // m or px, by which at least
  bool IsMarker() const { return std::holds_alternative<Marker>(point); }
};

// Markers that changed places for good from a frame on: what is labelled ids[k] is the marker that
// was labelled ids[k + 1] before, the last one the first.
struct SwappedMarkers {
  std::vector<int> ids;  // two, or more that changed places in turn
  int from_frame = 0;
};

struct Recording {
  std::filesystem::path path;  // the folder
  std::string name;
  double frame_rate = 30.0;  // Hz
  int frame_count = 1;
  Eigen::Vector3d gravity{0.0, 0.0, -9.81};  // m/s^2, world
  std::optional<double> ground_height;       // m; the ground is the plane z = height
  ClothDescription cloth;
  std::vector<HandleDescription> handles;
  std::vector<ObstacleDescription> obstacles;
  NoiseSigmas noise;
  Splits splits;
  std::vector<Camera> cameras;
  std::vector<CameraFiles> files;  // one a camera, in the same order; or none at all
  CloudFiles clouds;
  std::vector<Marker> markers;  // in file order
  std::vector<Track> tracks;    // in file order
  // Not in files: what PutLabelsRight and LeaveOutOutliers have done.
  std::vector<SwappedMarkers> put_right;
  std::vector<Outlier> left_out;  // of markers and tracks
};

// Reads the folder (recording-format version 1) and checks it as CheckRecording does. Rows of
// markers.csv and tracks.csv whose position is empty are left out. Never reads truth/.
// Throws InputError, one line, on anything missing, unknown, malformed or out of range.
Recording ReadRecording(const std::filesystem::path& folder);

// Checks the values of a recording in memory. Throws InputError as if it had been read from disk.
void CheckRecording(const Recording& recording);

// The files of a recording's folder, contents by name: recording.yaml and, where there is something
// to write, cameras.yaml, markers.csv, tracks.csv, initial.csv, handles/*.csv, obstacles/*.csv and
// copies of meshes. Numbers are the shortest decimals that read back as the same doubles. Pictures
// are not among them: whoever makes them puts them beside. Throws InputError where a value is
// wrong.
std::map<std::string, std::string> FilesOf(const Recording& recording);

// Writes these. Throws InputError as OutputFolder does, where the folder already holds a recording
// (unless it may be replaced) or anything else.
void WriteRecording(const Recording& recording, const std::filesystem::path& folder,
                    Overwrite overwrite = Overwrite::kRefuse);

// Index of the camera of that name, if there is one.
std::optional<int> FindCamera(const Recording& recording, const std::string& name);

// Whether any camera has images or a video, and whether any has finished silhouettes.
bool HasPictures(const Recording& recording);
bool HasMasks(const Recording& recording);
// Whether there is any cloud or depth picture.
bool HasClouds(const Recording& recording);

bool IsHeldOutFrame(const Recording& recording, int frame);
bool IsHeldOutCamera(const Recording& recording, int camera);

}  // namespace clothfit
