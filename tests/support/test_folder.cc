// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/test_folder.h"

#include <fstream>

#include <unistd.h>

namespace clothfit {

namespace fs = std::filesystem;

TestFolder::TestFolder() {
  std::string name = (fs::temp_directory_path() / "clothfit_test_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TestFolder::~TestFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path TestFolder::Write(const std::string& file, const std::string& text) const {
  fs::path path = path_ / file;
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

void WriteFiles(const TestFiles& files, const TestFolder& folder) {
  for (const auto& [name, text] : files) folder.Write(name, text);
}

std::string InputErrorOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    std::string text = error.what();
    EXPECT_EQ(text.find('\n'), std::string::npos) << "not one line: " << text;
    return text;
  }
  ADD_FAILURE() << "no InputError";
  return "";
}

TestFiles CompleteRecordingFiles() {
  TestFiles files;
  files["recording.yaml"] = R"(format: cloth-recording/1
name: two-corner-lift
frame_rate: 30.0
frame_count: 10
gravity: [0, 0, -9.81]
ground: {height: 0.0}
cloth:
  size: [1.4, 1.2]
  resolution: [31, 27]
  areal_density: 0.18
  initial:
    origin: [0, 0, 0.002]
    u_axis: [1, 0, 0]
    v_axis: [0, 1, 0]
handles:
  - {name: corner_a, uv: [0, 0], path: handles/corner_a.csv, path_sigma: 0.004}
  - {name: corner_b, uv: [1.4, 0], released_after: 7}
noise:
  marker: 0.003
  track: 0.6
  silhouette: 1.5
splits:
  held_out_frames: [8, 9]
  held_out_cameras: [cam1]
)";
  files["cameras.yaml"] = R"(cameras:
  - name: cam0
    size: [64, 48]
    K: [60, 0, 31.5, 0, 61, 23.5, 0, 0, 1]
    distortion: [0.1, -0.05, 0.001, -0.002, 0.01]
    R: [1, 0, 0, 0, 0, -1, 0, 1, 0]
    t: [-0.7, 0.6, 3]
  - name: cam1
    size: [64, 48]
    K: [60, 0, 31.5, 0, 60, 23.5, 0, 0, 1]
    R: [0, 1, 0, 0, 0, -1, -1, 0, 0]
    t: [0, 0, 4]
)";
  files["markers.csv"] =
      "frame,id,u,v,x,y,z\n"
      "0,3,0.5,0.25,0.501,0.249,0.001\n"
      "1,3,0.5,0.25,0.5,0.25,0.1\n"
      "1,4,1.4,1.2,,,\n"
      "2,4,1.4,1.2,1.39,1.2,0.2\n";
  files["tracks.csv"] =
      "frame,camera,id,u,v,x,y\n"
      "0,cam0,1,0.5,0.5,20.25,30.5\n"
      "0,cam1,1,0.5,0.5,21,31\n"
      "5,cam0,1,0.5,0.5,22,32\n";
  files["handles/corner_a.csv"] = "frame,x,y,z\n0,0,0,0.002\n1,0,0,0.05\n2,,,\n4,0,0,0.2\n";
  files["images/cam0/000000.png"] = "";
  files["images/cam0/000009.png"] = "";
  files["masks/cam1/000003.png"] = "";
  files["background/cam0.png"] = "";
  return files;
}

}  // namespace clothfit
