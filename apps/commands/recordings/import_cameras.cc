// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit import colmap and opencv: cameras.yaml from calibrations.
#include <memory>

#include "apps/commands/recordings/import.h"
#include "apps/options/config.h"
#include "apps/options/value_checks.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/printable.h"
#include "tracking/camera/world_change.h"
#include "tracking/import/cameras/colmap.h"
#include "tracking/import/cameras/opencv.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

struct CamerasOptions {
  std::string output;
  std::string up = "z", naming = "auto";
  double scale = 1.0;
  std::vector<double> transform;
  std::string model;               // of COLMAP
  std::vector<std::string> files;  // of OpenCV
  std::vector<int> image_size;
  bool camera_to_world = false, force = false;
  SceneOptions scene;
};

// Cameras in the world of their calibration, put into the recording's and written.
int ImportCameras(std::vector<Camera> cameras, std::vector<std::string> notes,
                  const CamerasOptions& options) {
  const fs::path folder = options.output;
  const WorldChange change = options.transform.empty()
                                 ? TurnUp(options.up, options.scale)
                                 : ParseSimilarity("--transform", options.transform);
  for (Camera& camera : cameras) camera = InWorld(camera, change);
  const SceneStart start = options.scene.Start(cameras, &notes);
  const SceneOptions& scene = options.scene;
  if (scene.DescribesScene() || scene.rate || scene.frames) CheckIsNew(folder);
  OutputFolder output = OpenRecording(folder, "import cameras", OverwriteIf(options.force));
  WriteCameras(cameras, &output);
  if (MissingOptions(start).empty()) WriteStart(start, &output);
  Print("{}: {} cameras\n", (folder / "cameras.yaml").string(), cameras.size());
  for (const Camera& camera : cameras) {
    const Eigen::Array3d millimetres = (CameraCentre(camera) * 1e3).array().round();
    const Eigen::Array3d centre = millimetres / 1e3 + 0.0;  // no "-0.000"
    Print("{}: {} x {} px, at ({:.3f}, {:.3f}, {:.3f}) m\n", camera.name, camera.width,
          camera.height, centre.x(), centre.y(), centre.z());
  }
  for (const std::string& note : notes) Print("{}\n", Printable(note));
  PrintWhatIsMissing(folder, start);
  return kExitSuccess;
}

int RunImportColmap(const CamerasOptions& options) {
  ColmapNaming naming = ColmapNaming::kAutomatic;
  if (options.naming == "stem") naming = ColmapNaming::kStem;
  if (options.naming == "folder") naming = ColmapNaming::kFolder;
  ColmapCameras model = ReadColmapCameras(options.model, naming);
  if (options.scale == 1.0 && options.transform.empty()) {
    model.notes.emplace_back(
        "COLMAP knows no metre: without --scale or --transform its unit is taken for one");
  }
  return ImportCameras(model.cameras, model.notes, options);
}

int RunImportOpencv(const CamerasOptions& options) {
  OpencvOptions reading;
  reading.camera_to_world = options.camera_to_world;
  if (!options.image_size.empty()) {
    reading.image_size = Eigen::Vector2i(options.image_size[0], options.image_size[1]);
  }
  std::vector<Camera> cameras;
  for (const std::string& file : options.files) {
    cameras.push_back(ReadOpencvCamera(file, reading));
  }
  return ImportCameras(cameras, {}, options);
}

void AddCamerasOptions(CLI::App* command, CamerasOptions* options) {
  BeginGroup(command, "The cameras, and the recording");
  command->add_option("-o,--output", options->output, "folder of the recording, old or new")
      ->type_name("RECORDING")
      ->required();
  command->add_option("--scale", options->scale, "m per unit of the calibration")
      ->type_name("M")
      ->capture_default_str();
  command->add_option("--up", options->up, "axis of the calibration that is turned up to z")
      ->type_name("AXIS")
      ->capture_default_str();
  command
      ->add_option("--transform", options->transform,
                   "4 x 4 similarity from the calibration's world, row by row, in place of both")
      ->type_name("S11 .. S44")
      ->expected(16)
      ->excludes("--scale")
      ->excludes("--up");
  command->add_flag("--force", options->force, "replace cameras.yaml, if it was imported");
  AddSceneOptions(command, &options->scene);
  command->add_option("--frames", options->scene.frames, "number of frames")->type_name("N");
}

}  // namespace

void AddImportColmap(CLI::App* import, Action* action) {
  CLI::App* const command =
      import->add_subcommand("colmap", "cameras of a sparse model that COLMAP wrote as text");
  const auto options = std::make_shared<CamerasOptions>();
  command->add_option("MODEL", options->model, "folder with cameras.txt and images.txt")
      ->required();
  command
      ->add_option("--names", options->naming,
                   "a camera for each image (stem) or each folder of images (folder)")
      ->type_name("auto|stem|folder")
      ->check(OneOf({"auto", "stem", "folder"}))
      ->capture_default_str();
  AddCamerasOptions(command, options.get());
  command->footer(
      "Example:\n  clothfit import colmap sparse/0 -o drape --scale 0.173 --up=-y --size 0.5 0.7 "
      "--ground 0 --frames 250 --rate 30");
  command->callback(
      [options, action] { *action = [options] { return RunImportColmap(*options); }; });
}

void AddImportOpencv(CLI::App* import, Action* action) {
  CLI::App* const command =
      import->add_subcommand("opencv", "cameras that OpenCV calibrated, one a file");
  const auto options = std::make_shared<CamerasOptions>();
  command->add_option("FILE", options->files, "YAML, XML or JSON of OpenCV's FileStorage")
      ->required();
  command->add_option("--image-size", options->image_size, "px; else as the files say")
      ->type_name("W H")
      ->expected(2);
  command->add_flag("--camera-to-world", options->camera_to_world,
                    "the poses in the files are of that direction");
  AddCamerasOptions(command, options.get());
  command->footer("Example:\n  clothfit import opencv cam0.yml cam1.yml -o drape --scale 0.001");
  command->callback(
      [options, action] { *action = [options] { return RunImportOpencv(*options); }; });
}

}  // namespace clothfit
