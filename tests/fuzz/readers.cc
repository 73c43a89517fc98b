// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Every reader of files that a stranger may have written, one program each for libFuzzer. An
// InputError is the right answer to most of what comes; anything else that is thrown ends the
// program, as a crash does.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/mesh/obj_file.h"
#include "fitting/files/evaluation_journal.h"
#include "fitting/files/npy_file.h"
#include "fitting/runs/recording_list.h"
#include "tracking/camera/camera_file.h"
#include "tracking/files/manifest.h"
#include "tracking/import/colmap.h"
#include "tracking/import/opencv.h"
#include "tracking/import/take_file.h"
#include "tracking/recording/cloud_file.h"
#include "tracking/recording/images.h"
#include "tracking/recording/recording.h"
#include "tracking/recording/summary.h"
#include "tracking/recording/tables.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

// A folder of this process, in memory where the system has such a place.
const fs::path& Folder() {
  static const fs::path folder = [] {
    const fs::path memory = "/dev/shm";
    const fs::path made = (fs::exists(memory) ? memory : fs::temp_directory_path()) /
                          ("clothfit-fuzz-" + std::to_string(getpid()));
    fs::create_directories(made / "masks" / "left");
    return made;
  }();
  return folder;
}

fs::path Write(const std::string& name, const std::string& bytes) {
  const fs::path file = Folder() / name;
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

// recording.yaml beside a table of markers and of a handle's path that are as they should be.
[[maybe_unused]] void ReadScene(const std::string& bytes) {
  Write("markers.csv", "frame,id,u,v,x,y,z\n0,0,0,0,0,0,1\n1,0,0,0,0,0,1\n");
  Write("path.csv", "frame,x,y,z\n0,0,0,1\n1,0,0,1\n");
  Write("cloth.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
  Write("recording.yaml", bytes);
  const Recording recording = ReadRecording(Folder());
  DescribeRecording(recording);
  Warnings(recording);
}

[[maybe_unused]] void ReadCameraFile(const std::string& bytes) {
  Recording recording = PlainRecording();
  recording.cameras = ReadCameras(Write("cameras.yaml", bytes));
  CheckRecording(recording);
}

[[maybe_unused]] void ReadTables(const std::string& bytes) {
  const fs::path file = Write("table.csv", bytes);
  const Recording recording = PlainRecording();
  std::vector<int> lines;
  const auto try_to = [](const auto& read) {
    try {
      read();
    } catch (const InputError&) {  // it is another table
    }
  };
  try_to([&] { ReadMarkers(file, &lines); });
  try_to([&] { ReadTracks(file, recording, &lines); });
  try_to([&] { ReadHandlePath(file, recording); });
  try_to([&] { ReadObstaclePath(file, recording); });
  try_to([&] { ReadPlacedPoints(file); });
}

[[maybe_unused]] void ReadMesh(const std::string& bytes) {
  const std::string file = Write("mesh.obj", bytes).string();
  try {
    ReadObjSurface(file);
  } catch (const InputError&) {  // as a cloth it may be right
  }
  ReadObj(file);
}

[[maybe_unused]] void ReadMaskPicture(const std::string& bytes) {
  Recording recording = PlainRecording();
  recording.files.resize(1);
  recording.files[0].masks[0] = Write("masks/left/000000.png", bytes);
  LoadMask(recording, 0, 0);
}

// The first byte says which kind of file it is.
[[maybe_unused]] void ReadCloud(const std::string& bytes) {
  const std::vector<std::string>& extensions = CloudExtensions();
  const std::size_t kind = bytes.empty() ? 0 : static_cast<unsigned char>(bytes[0]);
  ReadCloudFile(Write("cloud" + extensions[kind % extensions.size()],
                      bytes.substr(std::min<std::size_t>(1, bytes.size()))));
}

// Of any format of motion capture, which goes by the content.
[[maybe_unused]] void ReadTakes(const std::string& bytes) {
  std::vector<std::string> notes;
  TakeFileOptions options;
  options.skip_bad_rows = bytes.size() % 2 == 0;
  if (bytes.size() % 3 != 0) options.facts = {120.0, 1.0, "y"};
  ReadTake(Write("take", bytes), options, &notes);
}

[[maybe_unused]] void ReadOpencv(const std::string& bytes) {
  ReadOpencvCamera(Write("camera.yml", bytes), {});
}

[[maybe_unused]] void ReadColmap(const std::string& bytes) {
  const auto [cameras, images] = Halves(bytes);
  Write("cameras.txt", cameras);
  Write("images.txt", images);
  ReadColmapCameras(Folder());
}

[[maybe_unused]] void ReadArray(const std::string& bytes) {
  const fs::path file = Write("array.npy", bytes);
  try {
    ReadScalarsNpy(file);
  } catch (const InputError&) {  // of points, perhaps
  }
  ReadPointsNpy(file);
}

[[maybe_unused]] void ReadCheckpoint(const std::string& bytes) {
  EvaluationJournal journal(Write("checkpoint.bin", bytes));
  journal.Recall("all frames", Eigen::Vector2d(1.0, 2.0));
}

// The list of files in a folder of clothfit's: a run's, a diagnosis' or any other's.
[[maybe_unused]] void ReadFolder(const std::string& bytes) {
  Write(kManifestFile, bytes);
  KindOfFolder(Folder());
}

// Which recordings a fit of several is of.
[[maybe_unused]] void ReadRecordings(const std::string& bytes) {
  Write(kManifestFile, R"({"format": "clothfit-folder/1", "kind": "joint run", "files": {}})");
  Write("recordings.yaml", bytes);
  ReadRecordingList(Folder());
}

}  // namespace
}  // namespace clothfit

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    clothfit::CLOTHFIT_READER(std::string(reinterpret_cast<const char*>(data), size));
  } catch (const clothfit::InputError&) {
  }
  return 0;
}
