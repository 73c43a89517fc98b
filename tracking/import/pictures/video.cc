// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/pictures/video.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

#include "autodiff_sim/base/error.h"
#include "tracking/camera/camera_file.h"
#include "tracking/files/whole_file.h"
#include "tracking/import/pictures/folder.h"
#include "tracking/import/pictures/single_file.h"
#include "tracking/recording/limits.h"
#include "tracking/recording/pictures/images.h"
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

void CheckCamera(const NamedVideo& video, const VideoFacts& facts,
                 const std::vector<Camera>& cameras) {
  for (const Camera& camera : cameras) {
    if (camera.name != video.camera) continue;
    if (camera.width == facts.width && camera.height == facts.height) return;
    throw InputError(video.file.string(),
                     fmt::format("expected {} x {} px as in cameras.yaml, found {} x {}",
                                 camera.width, camera.height, facts.width, facts.height));
  }
  throw InputError(video.file.string(), IsNoCamera(video.camera, cameras));
}

// Sets a key that stands at the beginning of a line, and keeps all else as it is.
void ReplaceValue(const fs::path& file, const std::string& key, const std::string& value,
                  std::string* text) {
  size_t at = text->rfind("\n" + key + ":");
  at = StartsWith(*text, key + ":") ? 0 : at == std::string::npos ? at : at + 1;
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

using FoldersByCamera = std::map<std::string, PictureFolder>;  // by camera

// The number of frame 0 in all folders, since they are synchronous.
int FirstNumber(const FoldersByCamera& folders) {
  int first = std::numeric_limits<int>::max();
  for (const auto& [camera, folder] : folders) first = std::min(first, folder.first());
  return first;
}

VideoFacts FactsOf(const PictureFolder& folder, int first) {
  return {folder.width, folder.height, folder.last() - first + 1, 0.0};
}

// Where something of this camera's would have to be replaced, throws unless it may be.
void CheckPlaces(const NamedVideo& video, const FoldersByCamera& folders,
                 const OutputFolder& output) {
  const auto pictures = folders.find(video.camera);
  if (pictures != folders.end()) {
    for (const auto& [name, file] :
         PlacesOfPictures(pictures->second, video.camera, FirstNumber(folders))) {
      if (!IsSameFile(output.path() / name, file)) output.CheckMayWrite(name);
    }
    return;
  }
  CheckMayCopySingle(video.file, "videos", video.camera, output);
}

std::string DescribeFacts(const std::string& camera, const VideoFacts& facts) {
  const std::string rate =
      facts.frame_rate > 0.0 ? fmt::format(" at {:g} Hz", facts.frame_rate) : "";
  return fmt::format("{}: {} frames of {} x {} px{}", camera, facts.frame_count, facts.width,
                     facts.height, rate);
}

FoldersByCamera InspectFolders(const std::vector<NamedVideo>& videos) {
  FoldersByCamera folders;
  for (const NamedVideo& video : videos) {
    CheckName(video);
    if (fs::is_directory(video.file)) folders[video.camera] = InspectPictures(video.file);
  }
  return folders;
}

using FactsByCamera = std::map<std::string, VideoFacts>;  // by camera

// A PNG of a camera whose video is imported too, and as large.
void CheckBackground(const NamedVideo& background, const FactsByCamera& videos,
                     const OutputFolder& output) {
  const auto video = videos.find(background.camera);
  if (video == videos.end()) {
    throw InputError("--background",
                     fmt::format("'{}' is none of the cameras here; {}", background.camera,
                                 Suggestion(background.camera, NamesOf(videos))));
  }
  const auto [width, height] = InspectPng(background.file);
  if (width != video->second.width || height != video->second.height) {
    throw InputError(background.file.string(),
                     fmt::format("expected {} x {} px as its camera's video, found {} x {}",
                                 video->second.width, video->second.height, width, height));
  }
  CheckMayCopySingle(background.file, "background", background.camera, output);
}

// What all videos have in common; each is checked against the cameras.
ImportedVideos InspectAll(const std::vector<NamedVideo>& videos, const FoldersByCamera& folders,
                          const std::vector<NamedVideo>& backgrounds, const OutputFolder& output) {
  ImportedVideos result;
  FactsByCamera all_facts;
  const fs::path& folder = output.path();
  const fs::path cameras_file = folder / "cameras.yaml";
  std::vector<Camera> cameras;
  if (IsThere(cameras_file)) cameras = ReadCameras(cameras_file);
  for (const NamedVideo& video : videos) {
    const auto pictures = folders.find(video.camera);
    const VideoFacts facts = pictures == folders.end()
                                 ? InspectVideo(video.file)
                                 : FactsOf(pictures->second, FirstNumber(folders));
    CheckPlaces(video, folders, output);
    if (fs::exists(cameras_file)) CheckCamera(video, facts, cameras);
    if (!all_facts.emplace(video.camera, facts).second) {
      throw InputError(video.file.string(), "'" + video.camera + "' has two videos");
    }
    const bool has_rates = facts.frame_rate > 0.0 && result.frame_rate > 0.0;
    if (has_rates && !SameRate(facts.frame_rate, result.frame_rate)) {
      throw InputError(video.file.string(),
                       fmt::format("expected {} Hz as in {}, found {}", result.frame_rate,
                                   videos.front().file.string(), facts.frame_rate));
    }
    if (facts.frame_rate > 0.0) result.frame_rate = facts.frame_rate;
    result.frame_count = std::max(result.frame_count, facts.frame_count);
    result.notes.push_back(DescribeFacts(video.camera, facts));
    if (pictures != folders.end()) {
      result.notes.push_back(fmt::format("{}: {} pictures; number {} is frame 0", video.camera,
                                         pictures->second.pictures.size(), FirstNumber(folders)));
    } else if (fs::exists(folder / "images" / video.camera)) {
      result.notes.push_back(
          fmt::format("{}: its video is not looked at as long as there is images/{}", video.camera,
                      video.camera));
    }
  }
  std::set<std::string> seen;
  for (const NamedVideo& background : backgrounds) {
    CheckBackground(background, all_facts, output);
    if (!seen.insert(background.camera).second) {
      throw InputError(background.file.string(), "'" + background.camera + "' has two backgrounds");
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
                            const fs::path& folder, Overwrite overwrite,
                            const std::vector<NamedVideo>& backgrounds) {
  OutputFolder output = OpenRecording(folder, "import video", overwrite);
  const FoldersByCamera folders = InspectFolders(videos);
  ImportedVideos result = InspectAll(videos, folders, backgrounds, output);
  if (start.frame_rate) result.frame_rate = *start.frame_rate;
  const fs::path scene = folder / "recording.yaml";
  const bool has_scene = fs::exists(scene);
  if (has_scene && result.frame_rate == 0.0) {  // as a folder of pictures has it
    result.frame_rate = YamlValue::Load(scene).Require("frame_rate").Number();
  }
  if (!(result.frame_rate > 0.0)) {
    throw InputError(videos.front().file.string(), "does not say its frame rate; expected --rate");
  }
  const std::string updated = has_scene ? UpdatedScene(scene, result, overwrite) : "";
  if (!updated.empty()) CheckMayWrite(scene, overwrite);
  if (!has_scene) {
    start.frame_rate = result.frame_rate;
    start.frame_count = result.frame_count;
    if (MissingOptions(start).empty()) WriteStart(start, &output);
  }
  for (const NamedVideo& video : videos) {
    const auto pictures = folders.find(video.camera);
    if (pictures == folders.end())
      CopySingle(video.file, "videos", video.camera, &output);
    else
      CopyPictures(video.camera, pictures->second, FirstNumber(folders), &output);
  }
  for (const NamedVideo& background : backgrounds) {
    CopySingle(background.file, "background", background.camera, &output);
  }
  if (!updated.empty()) WriteWholeFile(scene, updated);
  return result;
}

}  // namespace clothfit
