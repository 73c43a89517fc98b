// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// In all of these an InputError is the right answer to most of what comes.
#include "tests/fuzz/readers.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <unistd.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/mesh/obj_file.h"
#include "fitting/batch/list.h"
#include "fitting/config/config.h"
#include "fitting/diagnosis/fitted/kept_fit.h"
#include "fitting/files/evaluation_journal.h"
#include "fitting/files/npy_file.h"
#include "fitting/files/version.h"
#include "fitting/jobs/list.h"
#include "fitting/report/diagnosis/record.h"
#include "fitting/runs/recording_list.h"
#include "tracking/camera/camera_file.h"
#include "tracking/files/manifest.h"
#include "tracking/import/cameras/colmap.h"
#include "tracking/import/cameras/opencv.h"
#include "tracking/import/take/file.h"
#include "tracking/recording/clouds/file.h"
#include "tracking/recording/folder/tables.h"
#include "tracking/recording/pictures/images.h"
#include "tracking/recording/recording.h"
#include "tracking/recording/warnings/summary.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

const fs::path& Folder() {
  fs::create_directories(FuzzFolder());
  return FuzzFolder();
}

fs::path Write(const std::string& name, const std::string& bytes) {
  const fs::path file = Folder() / name;
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
  return file;
}

// The input as two files, divided at its first zero byte.
std::pair<std::string, std::string> Halves(const std::string& bytes) {
  const std::size_t at = std::min(bytes.find('\0'), bytes.size());
  return {bytes.substr(0, at), bytes.substr(std::min(at + 1, bytes.size()))};
}

Recording PlainRecording() {
  Recording recording;
  recording.path = Folder();
  recording.name = "fuzz";
  recording.frame_count = 10;
  recording.cameras.resize(1);
  recording.cameras[0].name = "left";
  recording.cameras[0].width = 16;
  recording.cameras[0].height = 12;
  return recording;
}

// A file of clothfit's own names the version that wrote it.
std::string WithVersion(std::string bytes) {
  constexpr std::string_view kMark = "@VERSION@";
  const std::size_t at = bytes.find(kMark);
  return at == std::string::npos ? bytes : bytes.replace(at, kMark.size(), Version());
}

// recording.yaml beside a table of markers and of a handle's path that are as they should be.
void ReadScene(const std::string& bytes) {
  Write("markers.csv", "frame,id,u,v,x,y,z\n0,0,0,0,0,0,1\n1,0,0,0,0,0,1\n");
  Write("path.csv", "frame,x,y,z\n0,0,0,1\n1,0,0,1\n");
  Write("cloth.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
  Write("recording.yaml", bytes);
  const Recording recording = ReadRecording(Folder());
  DescribeRecording(recording);
  Warnings(recording);
}

void ReadCameraFile(const std::string& bytes) {
  Recording recording = PlainRecording();
  recording.markers.push_back({0, 0, {0.0, 0.0}, {0.0, 0.0, 1.0}});  // something has been seen
  recording.cameras = ReadCameras(Write("cameras.yaml", bytes));
  CheckRecording(recording);
}

void ReadTables(const std::string& bytes) {
  const fs::path file = Write("table.csv", bytes);
  const Recording recording = PlainRecording();
  std::vector<int> lines;
  int taken = 0;
  const auto try_to = [&](const auto& read) {
    try {
      read();
      ++taken;
    } catch (const InputError&) {  // it is another table
    }
  };
  try_to([&] { ReadMarkers(file, &lines); });
  try_to([&] { ReadTracks(file, recording, &lines); });
  try_to([&] { ReadHandlePath(file, recording); });
  try_to([&] { ReadObstaclePath(file, recording); });
  try_to([&] { ReadPlacedPoints(file); });
  if (taken == 0) throw InputError(file.string(), "is none of the tables");
}

void ReadMesh(const std::string& bytes) {
  const std::string file = Write("mesh.obj", bytes).string();
  try {
    ReadObjSurface(file);
  } catch (const InputError&) {  // as a cloth it may be right
  }
  ReadObj(file);
}

void ReadMaskPicture(const std::string& bytes) {
  Recording recording = PlainRecording();
  recording.files.resize(1);
  recording.files[0].masks[0] = Write("masks/left/000000.png", bytes);
  LoadMask(recording, 0, 0);
}

void ReadDepthPicture(const std::string& bytes) {
  Recording recording = PlainRecording();
  recording.files.resize(1);
  recording.files[0].depth[0] = Write("depth/left/000000.png", bytes);
  LoadDepthPicture(recording, 0, 0);
}

// The first byte says which kind of file it is.
void ReadCloud(const std::string& bytes) {
  const std::vector<std::string>& extensions = CloudExtensions();
  const std::size_t kind = bytes.empty() ? 0 : static_cast<unsigned char>(bytes[0]);
  ReadCloudFile(Write("cloud" + extensions[kind % extensions.size()],
                      bytes.substr(std::min<std::size_t>(1, bytes.size()))));
}

// Of any format of motion capture, which goes by the content.
void ReadTakes(const std::string& bytes) {
  std::vector<std::string> notes;
  TakeFileOptions options;
  options.skip_bad_rows = bytes.size() % 2 == 0;
  if (bytes.size() % 3 != 0) options.facts = {120.0, 1.0, "y"};
  ReadTake(Write("take", bytes), options, &notes);
}

void ReadOpencv(const std::string& bytes) { ReadOpencvCamera(Write("camera.yml", bytes), {}); }

void ReadColmap(const std::string& bytes) {
  const auto [cameras, images] = Halves(bytes);
  Write("cameras.txt", cameras);
  Write("images.txt", images);
  ReadColmapCameras(Folder());
}

void ReadArray(const std::string& bytes) {
  const fs::path file = Write("array.npy", bytes);
  try {
    ReadScalarsNpy(file);
  } catch (const InputError&) {  // of points, perhaps
    ReadPointsNpy(file);
  }
}

// What follows the first line.
void ReadCheckpoint(const std::string& bytes) {
  const fs::path file = Folder() / "checkpoint.bin";
  fs::remove(file);
  EvaluationJournal empty(file);
  std::ofstream(file, std::ios::binary | std::ios::app) << bytes;
  EvaluationJournal journal(file);
  if (!journal.Recall("all frames", Eigen::Vector2d(1.0, 2.0)))
    throw InputError(file.string(), "has nothing of these parameters");
}

// The list of files in a folder of clothfit's: a run's, a diagnosis' or any other's.
void ReadFolder(const std::string& bytes) {
  Write(kManifestFile, bytes);
  KindOfFolder(Folder());
}

// Which recordings a fit of several is of.
void ReadRecordings(const std::string& bytes) {
  Write(kManifestFile, R"({"format": "clothfit-folder/1", "kind": "joint run", "files": {}})");
  Write("recordings.yaml", bytes);
  ReadRecordingList(Folder());
}

void ReadFitConfig(const std::string& bytes) {
  FitConfig config = DefaultConfig(PlainRecording());
  ReadConfig(Write("config.yaml", bytes), &config);
  ConfigToYaml(config);
}

// Fits of a recording that is as it should be.
void ReadBatch(const std::string& bytes) {
  Write("rec/recording.yaml",
        "format: cloth-recording/1\nname: rec\nframe_rate: 30\nframe_count: 2\n"
        "gravity: [0, 0, -9.81]\n"
        "cloth:\n  size: [1, 1]\n  resolution: [3, 3]\n"
        "  initial: {origin: [0, 0, 1], u_axis: [1, 0, 0], v_axis: [0, 1, 0]}\n");
  Write("rec/markers.csv", "frame,id,u,v,x,y,z\n0,0,0,0,0,0,1\n1,0,0,0,0,0,1\n");
  ReadBatchList(Write("list.yaml", bytes));
}

void ReadJobs(const std::string& bytes) {
  Write(kJobListFile, WithVersion(bytes));
  const JobList list = ReadJobList(Folder());
  JobListAsText(list);
}

// diagnosis.json beside files that are there.
void ReadDiagnosis(const std::string& bytes) {
  for (const char* file : {"baseline.npy", "model.npy", "config.yaml", "log.txt"}) Write(file, "");
  Write("diagnosis.json", WithVersion(bytes));
  ReadDiagnosisRecord(Folder());
}

void ReadKeptFit(const std::string& bytes) {
  const std::optional<FitResult> fit = FitFromBytes(bytes);
  if (!fit) throw InputError("kept fit", "is damaged");
  FitAsBytes(*fit);
}

}  // namespace

const fs::path& FuzzFolder() {
  static const fs::path folder = [] {
    const fs::path memory = "/dev/shm";
    return (fs::exists(memory) ? memory : fs::temp_directory_path()) /
           ("clothfit-fuzz-" + std::to_string(getpid()));
  }();
  return folder;
}

const std::vector<FuzzedReader>& FuzzedReaders() {
  static const std::vector<FuzzedReader> readers = {
      {"Array", ReadArray},
      {"Batch", ReadBatch},
      {"CameraFile", ReadCameraFile},
      {"Checkpoint", ReadCheckpoint},
      {"Cloud", ReadCloud},
      {"Colmap", ReadColmap},
      {"DepthPicture", ReadDepthPicture},
      {"Diagnosis", ReadDiagnosis},
      {"FitConfig", ReadFitConfig},
      {"Folder", ReadFolder},
      {"Jobs", ReadJobs},
      {"KeptFit", ReadKeptFit},
      {"MaskPicture", ReadMaskPicture},
      {"Mesh", ReadMesh},
      {"Opencv", ReadOpencv},
      {"Recordings", ReadRecordings},
      {"Scene", ReadScene},
      {"Tables", ReadTables},
      {"Takes", ReadTakes},
  };
  return readers;
}

}  // namespace clothfit
