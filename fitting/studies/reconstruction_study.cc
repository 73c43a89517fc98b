// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Hasler et al. 2007, Figures 7 and 8: the last frame, reconstructed in several ways, and two
// original views of it.
#include <Eigen/Geometry>
#include <fmt/format.h>

#include "fitting/pictures/picture.h"
#include "fitting/studies/study.h"
#include "fitting/studies/study_recording.h"
#include "tracking/files/whole_file.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

struct Variant {
  const char *name, *title;
  double linear, reciprocal;  // N/m, N m^2
  int cameras;
};
// As strong as the attraction study's: 1000 N/m together, and what pulls as 100 N/m at 1 cm.
constexpr Variant kVariants[] = {{"strong-linear", "strong linear forces", 1000.0, 0.0, 7},
                                 {"one-camera", "one camera", 0.0, 0.0, 1},
                                 {"reciprocal", "reciprocal forces", 0.0, 1e-4, 7},
                                 {"three-cameras", "three cameras", 0.0, 0.0, 3},
                                 {"seven-cameras", "seven cameras", 0.0, 0.0, 7}};

std::vector<Job> ReconstructionJobs(const StudyOptions& options) {
  std::vector<Job> jobs;
  for (const Variant& variant : kVariants) {
    StudyFit fit;
    fit.experiment = options.experiments.back();
    fit.search = options.search;
    fit.linear = variant.linear;
    fit.reciprocal = variant.reciprocal;
    fit.points = variant.linear + variant.reciprocal > 0.0 ? "markers" : "none";
    fit.cameras = variant.cameras;
    fit.keep_surface = true;
    jobs.push_back(FitJob(variant.name, fit, options));
  }
  return jobs;
}

Eigen::VectorXd AsVector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

// `side`: of the cloth, m.
void Draw(const StudyOptions& options, const std::vector<DoneFit>& fits, double side,
          const fs::path& file) {
  const ClothMesh mesh = MakeGrid({side, side}, {options.particles, options.particles});
  const Eigen::VectorXd truth = AsVector(fits.front().result.true_surface);
  const Eigen::Vector3d centre =
      Eigen::Map<const Eigen::Matrix3Xd>(truth.data(), 3, truth.size() / 3).rowwise().mean();
  std::vector<ClothPanel> panels = {{"truth", truth, centre}};
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (!fits[i].result.surface.empty())
      panels.push_back({kVariants[i].title, AsVector(fits[i].result.surface), centre});
  }
  std::vector<std::vector<ClothPanel>> rows(2);
  while (panels.size() % 2 != 0) panels.push_back({"", truth, centre});
  for (std::size_t i = 0; i < panels.size(); ++i)
    rows[i < panels.size() / 2 ? 0 : 1].push_back(panels[i]);
  DrawCloths(mesh, rows, 1.4 * side, PictureOptions(), file);
}

// Figure 8: a view from the side and the one from the ceiling.
void CopyViews(const Recording& recording, const fs::path& folder) {
  for (const auto& [camera, name] :
       {std::pair("cam0", "view-side.png"), std::pair("ceiling", "view-top.png")}) {
    const std::optional<int> index = FindCamera(recording, camera);
    if (!index) continue;
    const auto& images = recording.files[static_cast<std::size_t>(*index)].images;
    if (!images.empty())
      fs::copy_file(images.rbegin()->second, folder / name, fs::copy_options::overwrite_existing);
  }
}

std::string ReconstructionStudyReport(const StudyOptions& options, const std::vector<Job>& jobs,
                                      const std::vector<JobResult>& results,
                                      const StudyPlace& place) {
  const std::vector<DoneFit> fits = DoneFits(jobs, results);
  std::string csv = "variant,error_px,all_px,truth_mm,roughness,true_roughness,simulations\n";
  std::string text =
      "| variant | error, px | px a picture, all seven | mm from truth | roughness over true | "
      "simulations |\n|---|---:|---:|---:|---:|---:|\n";
  for (std::size_t i = 0; i < results.size(); ++i) {
    const StudyFitResult& r = fits[i].result;
    csv += fmt::format("{},{},{},{},{},{},{}\n", results[i].name, r.error, r.all_pixels,
                       r.truth_rms, r.roughness, r.true_roughness, r.simulations);
    text += fmt::format("| {} | {:.0f} | {:.1f} | {:.1f} | {:.2f} | {:.0f} |\n", results[i].name,
                        r.error, r.all_pixels, r.truth_rms, r.roughness / r.true_roughness,
                        r.simulations);
  }
  WriteWholeFile(place.folder / "reconstructions.csv", csv);
  const Recording recording =
      ReadRecording(PictureFolder(place.recordings, options, options.experiments.back()));
  if (fits.size() == std::size(kVariants))
    Draw(options, fits, recording.cloth.size.x(), place.folder / "reconstructions.png");
  CopyViews(recording, place.folder);
  return text;
}

}  // namespace

Study ReconstructionStudy() {
  Study study;
  study.name = "reconstructions";
  study.doc = "Figures 7 and 8: the last frame of the last experiment in several ways";
  study.files = {"view-side.png", "view-top.png"};
  study.jobs = ReconstructionJobs;
  study.report = ReconstructionStudyReport;
  return study;
}

}  // namespace clothfit
