// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit import: makes recordings, or parts of them, of what other programs write.
#include "apps/commands/recordings/import.h"

#include "apps/commands/commands.h"
#include "apps/options/config.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/input_file.h"
#include "autodiff_sim/base/printable.h"
#include "fitting/jobs/shell.h"
#include "tracking/import/pictures/corner_placement.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

// Of NAME=U,V. Nobody knows its path.
HandleDescription HandleOf(const std::string& text) {
  const std::size_t equals = text.find('='), comma = text.rfind(',');
  if (equals != std::string::npos && comma != std::string::npos && equals < comma) {
    const std::optional<double> u = ParseNumber(text.substr(equals + 1, comma - equals - 1));
    const std::optional<double> v = ParseNumber(text.substr(comma + 1));
    HandleDescription handle;
    handle.name = text.substr(0, equals);
    if (u && v) {
      handle.uv = {*u, *v};
      return handle;
    }
  }
  throw InputError("--handle", "expected NAME=U,V such as left=0,0, found " + Quoted(text));
}

}  // namespace

SceneStart SceneOptions::Start(const std::vector<Camera>& cameras,
                               std::vector<std::string>* notes) const {
  const auto vector = [](const std::vector<double>& three) {
    return Eigen::Vector3d(three[0], three[1], three[2]);
  };
  SceneStart start;
  if (!size.empty()) start.size = Eigen::Vector2d(size[0], size[1]);
  start.frame_count = frames;
  start.frame_rate = rate;
  start.ground_height = ground;
  if (!origin.empty()) start.origin = vector(origin);
  if (!u_axis.empty()) start.u_axis = vector(u_axis);
  if (!v_axis.empty()) start.v_axis = vector(v_axis);
  for (const std::string& text : handles) start.handles.push_back(HandleOf(text));
  start.areal_density = areal_density;
  start.held_out_share = held_out_share;
  if (corners.empty()) return start;
  if (!start.size) throw InputError("--corner", "expected --size too");
  std::vector<SeenCorner> seen;
  for (const auto& [camera, u, v, x, y] : corners) seen.push_back({camera, {u, v}, {x, y}});
  const SheetPlacement placement = PlaceByCorners(seen, cameras, *start.size);
  start.origin = placement.flat.origin;
  start.u_axis = placement.flat.u_axis;
  start.v_axis = placement.flat.v_axis;
  notes->insert(notes->end(), placement.notes.begin(), placement.notes.end());
  return start;
}

bool SceneOptions::DescribesScene() const {
  return !size.empty() || !origin.empty() || !u_axis.empty() || !v_axis.empty() || ground ||
         !corners.empty() || !handles.empty() || areal_density || held_out_share != 0.0;
}

void CheckIsNew(const std::filesystem::path& folder) {
  if (!IsThere(folder / "recording.yaml")) return;
  throw InputError((folder / "recording.yaml").string(),
                   "exists already; expected no options that describe the scene");
}

void AddSceneOptions(CLI::App* command, SceneOptions* options) {
  BeginGroup(command, "The scene, for a recording that is new");
  command->add_option("--size", options->size, "of the cloth, m along u and v")
      ->type_name("U V")
      ->expected(2);
  command
      ->add_option("--ground", options->ground,
                   "height of a ground, m; the cloth lies on it unless --origin is given")
      ->type_name("M");
  CLI::Option* const corner = command->add_option(
      "--corner", options->corners,
      "a point of the flat cloth (m) that CAMERA sees at pixel (X, Y) at first; repeat it");
  corner->type_name("CAMERA U V X Y")->allow_extra_args(false);
  const auto add_vector = [&](const char* name, std::vector<double>* value, const char* help) {
    command->add_option(name, *value, help)->type_name("X Y Z")->expected(3)->excludes(corner);
  };
  add_vector("--origin", &options->origin, "where (0, 0) of the flat cloth is at first, m");
  add_vector("--u-axis", &options->u_axis, "direction of u at first; else x");
  add_vector("--v-axis", &options->v_axis, "direction of v at first; else y");
  command
      ->add_option(
          "--handle", options->handles,
          "point of the cloth (m) that something holds, on a path that a fit finds; may be "
          "repeated")
      ->type_name("NAME=U,V")
      ->allow_extra_args(false);
  AddDensityOption(command, &options->areal_density);
  AddHeldOutOption(command, &options->held_out_share);
  command->add_option("--rate", options->rate, "frames a second; of videos else as they say")
      ->type_name("HZ");
}

void AddDensityOption(CLI::App* command, std::optional<double>* areal_density) {
  command->add_option("--density", *areal_density, "of the cloth, kg/m^2; else a fit finds it")
      ->type_name("KG/M2");
}

void AddHeldOutOption(CLI::App* command, double* share) {
  command->add_option("--held-out", *share, "share of the frames, at the end")
      ->type_name("SHARE")
      ->capture_default_str();
}

void PrintWhatIsMissing(const std::filesystem::path& folder, const SceneStart& start) {
  const bool has_recording = std::filesystem::exists(folder / "recording.yaml");
  const bool has_cameras = std::filesystem::exists(folder / "cameras.yaml");
  const std::string place = ShellWord(folder.string());
  if (!has_recording) {
    Print("{} is not written: it needs {} too\n", (folder / "recording.yaml").string(),
          JoinNames(MissingOptions(start)));
  }
  if (!has_cameras) {
    Print("{} is needed too: see 'clothfit import colmap' and 'opencv'\n",
          (folder / "cameras.yaml").string());
    PrintNext("clothfit import opencv FILE ... -o " + place + ", or colmap MODEL");
  } else if (!has_recording) {
    PrintNext("clothfit import video CAMERA=FILE ... -o " + place);
  } else {
    PrintNext("clothfit check " + place);
  }
}

void AddImportCommand(CLI::App* app, Action* action) {
  CLI::App* const import = app->add_subcommand(
      "import", "make recordings of motion capture, calibrated cameras and videos");
  import->require_subcommand(1);
  import->footer(
      "Examples:\n"
      "  clothfit import markers take.csv -o take\n"
      "  clothfit import opencv cam0.yml cam1.yml -o drape --scale 0.001\n"
      "  clothfit import video cam0=a.mp4 cam1=b.mp4 -o drape --size 0.5 0.7 --ground 0");
  AddImportMarkers(import, action);
  AddImportColmap(import, action);
  AddImportOpencv(import, action);
  AddImportVideo(import, action);
}

}  // namespace clothfit
