// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/video.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

#include "autodiff_sim/base/error.h"
#include "tracking/camera/camera_file.h"
#include "tracking/files/whole_file.h"
#include "tracking/recording/images.h"
#include "tracking/recording/limits.h"
#include "tracking/text/text.h"
#include "tracking/text/yaml_reader.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

bool SameRate(double a, double b) {
  constexpr double kTolerance = 5e-4;  // 30 and 29.97 Hz are a thousandth apart
  return std::abs(a - b) <= kTolerance * b;
}

void CheckName(const NamedVideo& video) {
  const std::string& name = video.camera;
  const bool usable = !name.empty() && name.front() != '.' && TrimBlanks(name) == name &&
                      name.find_first_of("/\\,") == std::string::npos;
  if (usable) return;
  throw InputError(video.file.string(), fmt::format("'{}' cannot name a camera", name));
}

// Where a camera's video already is, by whatever extension.
std::vector<fs::path> VideosThere(const fs::path& folder, const std::string& camera) {
  std::vector<fs::path> there;
  if (!fs::is_directory(folder / "videos")) return there;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "videos")) {
    if (entry.path().stem() == camera) there.push_back(entry.path());
  }
  return there;
}

void CheckCamera(const NamedVideo& video, const VideoFacts& facts,
                 const std::vector<Camera>& cameras) {
  std::vector<std::string> names;
  for (const Camera& camera : cameras) {
    names.push_back(camera.name);
    if (camera.name != video.camera) continue;
    if (camera.width == facts.width && camera.height == facts.height) return;
    throw InputError(video.file.string(),
                     fmt::format("expected {} x {} px as in cameras.yaml, found {} x {}",
                                 camera.width, camera.height, facts.width, facts.height));
  }
  throw InputError(video.file.string(), fmt::format("'{}' is no camera of cameras.yaml; {}",
                                                    video.camera, Suggestion(video.camera, names)));
}

// Sets a key that stands at the beginning of a line, and keeps all else as it is.
void ReplaceValue(const fs::path& file, const std::string& key, const std::string& value,
                  std::string* text) {
  size_t at = text->rfind("\n" + key + ":");
  at = text->rfind(key + ":", 0) == 0 ? 0 : at == std::string::npos ? at : at + 1;
  if (at == std::string::npos) {
    throw InputError(file.string(), fmt::format("expected a line '{}: {}'", key, value));
  }
  const size_t begin = at + key.size() + 1;
  const size_t end = std::min(text->find_first_of("#\n", begin), text->size());
  const bool has_comment = end < text->size() && (*text)[end] == '#';
  text->replace(begin, end - begin, " " + value + (has_comment ? " " : ""));
}

// The new text of recording.yaml, or nothing where it is right as it is.
std::string UpdatedScene(const fs::path& file, const ImportedVideos& found, Overwrite overwrite) {
  const YamlValue top = YamlValue::Load(file);
  const YamlValue rate = top.Require("frame_rate");
  const YamlValue count = top.Require("frame_count");
  const bool same_rate = SameRate(found.frame_rate, rate.Number());
  const bool enough_frames = found.frame_count <= count.Integer();
  if (same_rate && enough_frames) return "";
  if (overwrite == Overwrite::kRefuse) {
    const YamlValue& wrong = same_rate ? count : rate;
    wrong.Fail(
        fmt::format("{}, but the videos have {} frames at {} Hz; --force sets it",
                    same_rate ? std::to_string(count.Integer()) : FormatNumber(rate.Number()),
                    found.frame_count, found.frame_rate));
  }
  std::string text = ReadTextFile(file);
  if (!same_rate) ReplaceValue(file, "frame_rate", FormatNumber(found.frame_rate), &text);
  if (!enough_frames) ReplaceValue(file, "frame_count", std::to_string(found.frame_count), &text);
  return text;
}

std::string PlaceOf(const fs::path& file) { return "videos/" + file.filename().string(); }

// One file, or a copy of it.
bool IsSameVideo(const fs::path& copy, const fs::path& file) {
  std::error_code ignored;
  if (fs::equivalent(copy, file, ignored)) return true;
  if (!fs::is_regular_file(copy) || fs::file_size(copy) != fs::file_size(file)) return false;
  std::ifstream one(copy, std::ios::binary), other(file, std::ios::binary);
  return std::equal(std::istreambuf_iterator<char>(one), {}, std::istreambuf_iterator<char>(other));
}

// Whole or not at all.
void CopyVideo(const NamedVideo& video, OutputFolder* folder) {
  const std::string name = "videos/" + video.camera + video.file.extension().string();
  const fs::path copy = folder->path() / name;
  if (IsSameVideo(copy, video.file)) return;
  std::error_code error;
  folder->Add({name});
  PartFile part(copy);
  fs::copy_file(video.file, part.path(), fs::copy_options::overwrite_existing, error);
  if (error) throw InputError(copy.string(), "cannot be written: " + error.message());
  part.MoveToPlace();
  for (const fs::path& there : VideosThere(folder->path(), video.camera)) {
    if (PlaceOf(there) != name) folder->Remove({PlaceOf(there)});
  }
}

// What all videos have in common; each is checked against the cameras.
ImportedVideos InspectAll(const std::vector<NamedVideo>& videos, const OutputFolder& output) {
  ImportedVideos result;
  const fs::path& folder = output.path();
  const fs::path cameras_file = folder / "cameras.yaml";
  std::vector<Camera> cameras;
  if (IsThere(cameras_file)) cameras = ReadCameras(cameras_file);
  for (size_t i = 0; i < videos.size(); ++i) {
    const NamedVideo& video = videos[i];
    CheckName(video);
    const VideoFacts facts = InspectVideo(video.file);
    for (const fs::path& there : VideosThere(folder, video.camera)) {
      if (!IsSameVideo(there, video.file)) output.CheckMayWrite(PlaceOf(there));
    }
    if (fs::exists(cameras_file)) CheckCamera(video, facts, cameras);
    for (size_t j = 0; j < i; ++j) {
      if (videos[j].camera != video.camera) continue;
      throw InputError(video.file.string(), "'" + video.camera + "' has two videos");
    }
    if (i > 0 && !SameRate(facts.frame_rate, result.frame_rate)) {
      throw InputError(video.file.string(),
                       fmt::format("expected {} Hz as in {}, found {}", result.frame_rate,
                                   videos.front().file.string(), facts.frame_rate));
    }
    if (i == 0) result.frame_rate = facts.frame_rate;
    result.frame_count = std::max(result.frame_count, facts.frame_count);
    result.notes.push_back(fmt::format("{}: {} frames of {} x {} px at {:g} Hz", video.camera,
                                       facts.frame_count, facts.width, facts.height,
                                       facts.frame_rate));
    if (fs::exists(folder / "images" / video.camera)) {
      result.notes.push_back(
          fmt::format("{}: its video is not looked at as long as there is images/{}", video.camera,
                      video.camera));
    }
  }
  return result;
}

}  // namespace

VideoFacts InspectVideo(const fs::path& file) {
  cv::VideoCapture video = OpenVideo(file);
  cv::Mat picture;
  bool is_read =
      IsPictureSize(video.get(cv::CAP_PROP_FRAME_WIDTH), video.get(cv::CAP_PROP_FRAME_HEIGHT));
  try {
    is_read = is_read && video.read(picture);
  } catch (const cv::Exception&) {
    is_read = false;
  }
  if (!is_read || picture.empty()) throw InputError(file.string(), "cannot be read as a video");
  VideoFacts facts;
  facts.width = picture.cols;
  facts.height = picture.rows;
  facts.frame_count = cvRound(video.get(cv::CAP_PROP_FRAME_COUNT));
  facts.frame_rate = video.get(cv::CAP_PROP_FPS);
  if (facts.frame_count < 1) throw InputError(file.string(), "does not say how many frames it has");
  return facts;
}

ImportedVideos ImportVideos(const std::vector<NamedVideo>& videos, SceneStart start,
                            const fs::path& folder, Overwrite overwrite) {
  OutputFolder output = OpenRecording(folder, "import video", overwrite);
  ImportedVideos result = InspectAll(videos, output);
  if (start.frame_rate) result.frame_rate = *start.frame_rate;
  if (!(result.frame_rate > 0.0)) {
    throw InputError(videos.front().file.string(), "does not say its frame rate; expected --rate");
  }
  const fs::path scene = folder / "recording.yaml";
  const bool has_scene = fs::exists(scene);
  const std::string updated = has_scene ? UpdatedScene(scene, result, overwrite) : "";
  if (!updated.empty()) CheckMayWrite(scene, overwrite);
  if (!has_scene) {
    start.frame_rate = result.frame_rate;
    start.frame_count = result.frame_count;
    if (MissingOptions(start).empty()) WriteStart(start, &output);
  }
  for (const NamedVideo& video : videos) CopyVideo(video, &output);
  if (!updated.empty()) WriteWholeFile(scene, updated);
  return result;
}

}  // namespace clothfit
