// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/studies/study_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/residuals/synthesis_error.h"
#include "fitting/scene/surface_truth.h"
#include "fitting/studies/comparison.h"
#include "fitting/studies/roughness.h"
#include "fitting/studies/study_recording.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr double kSpread = 0.5;  // of starts other than the first, see ComparisonOptions

// Every k-th of the points that were tracked, so that no frame has many more than asked for.
template <class Point, class Group>
void Thin(std::vector<Point>* points, int most, int frames, const Group& group) {
  std::map<int, std::map<int, int>> counts;  // by group and id
  for (const Point& point : *points) ++counts[group(point)][point.id];
  std::set<std::pair<int, int>> kept;
  for (const auto& [g, of_id] : counts) {
    double all = 0.0;
    for (const auto& [id, count] : of_id) all += count;
    const int every = std::max(1, static_cast<int>(std::ceil(all / frames / most)));
    int index = 0;
    for (const auto& [id, count] : of_id) {
      if (index++ % every == 0) kept.emplace(g, id);
    }
  }
  const auto is_left_out = [&](const Point& point) {
    return kept.count({group(point), point.id}) == 0;
  };
  points->erase(std::remove_if(points->begin(), points->end(), is_left_out), points->end());
}

// The first `count` of the cameras: around the room at even distances, then those between them,
// then the ceiling's.
std::vector<int> Cameras(int count) {
  std::vector<int> order = {0, 2, 4, 1, 3, 5, 6};
  order.resize(static_cast<std::size_t>(std::clamp(count, 1, 7)));
  return order;
}

Recording ReadUsed(const fs::path& folder, const StudyFit& fit, const StudyOptions& options) {
  Recording recording = ReadRecording(folder);
  const std::vector<int> used = Cameras(fit.cameras);
  for (int c = 0; c < static_cast<int>(recording.cameras.size()); ++c) {
    if (std::find(used.begin(), used.end(), c) == used.end())
      recording.splits.held_out_cameras.push_back(recording.cameras[c].name);
  }
  if (fit.points != "markers") recording.markers.clear();
  if (fit.points != "tracks") recording.tracks.clear();
  Thin(&recording.markers, options.points, recording.frame_count, [](const Marker&) { return 0; });
  Thin(&recording.tracks, options.points, recording.frame_count,
       [](const Track& track) { return track.camera; });
  return recording;
}

// Weights of 1, so that the scene holds all that is used.
FitConfig SceneConfig(const Recording& recording, const StudyFit& fit,
                      const StudyOptions& options) {
  FitConfig config = DefaultConfig(recording);
  config.resolution = {options.particles, options.particles};
  config.coarse_resolution = 0;
  config.attract = true;  // gives tracks their rays
  for (auto& [name, setting] : config.parameters) {
    setting.free =
        std::find(options.fabric.begin(), options.fabric.end(), name) != options.fabric.end();
  }
  const Contender contender = ParseContender("search", fit.search);
  config.optimiser = contender.optimiser;
  config.loops = contender.strategy;
  ComparisonOptions starts;
  starts.spread = kSpread;
  starts.seed = options.seed;
  return StartOf(config, starts, fit.start);
}

double AttractorsPerFrame(const Scene& scene) {
  double count = static_cast<double>(scene.markers.size());
  for (const TrackObservation& track : scene.tracks) count += scene.IsFitted(track) ? 1.0 : 0.0;
  return std::max(1.0, count / scene.recording.frame_count);
}

void SetPull(const StudyFit& fit, const Scene& scene, FitConfig* config) {
  const double share = 1.0 / AttractorsPerFrame(scene);
  for (const char* term : {"attraction_point.", "attraction_ray."}) {
    const std::string name = term;
    config->parameters.at(name + "linear").value = share * fit.linear;
    config->parameters.at(name + "reciprocal").value = share * fit.reciprocal;
  }
}

double Rms(const std::vector<double>& distances) {
  double sum = 0.0;
  for (const double d : distances) sum += d * d;
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, distances.size())));
}

// The true surface's points at the mesh's own particles.
Eigen::VectorXd TrueSurface(const fs::path& folder, const Scene& scene, int frame, int generator) {
  const Eigen::Vector2d size = scene.recording.cloth.size;
  const ClothMesh grid = MakeGrid(size, {generator, generator});
  Eigen::VectorXd x(3 * grid.num_particles());
  Eigen::Index next = 0;
  for (const TruthPoint& point : ReadTruthPoints(folder)) {
    if (point.frame != frame || next >= x.size()) continue;
    x.segment<3>(next) = point.position;
    next += 3;
  }
  const std::vector<SurfacePoint> places = LocateOnCloth(grid, scene.mesh.uv);
  Eigen::VectorXd at(3 * scene.mesh.num_particles());
  for (std::size_t i = 0; i < places.size(); ++i)
    at.segment<3>(3 * static_cast<Eigen::Index>(i)) = places[i].At(x);
  return at;
}

// How far what was found is from all cameras, from the points and from the truth.
void Judge(const fs::path& folder, const StudyFit& fit, const StudyOptions& options,
           const Scene& scene, const SearchResult& found, StudyFitResult* result) {
  StudyFit all = fit;
  all.cameras = 7;
  const Recording recording = ReadUsed(folder, all, options);
  FitConfig config = SceneConfig(recording, all, options);
  const Scene whole = MakeScene(recording, config);
  config.beta = 0.0;
  const SynthesisError error(whole, config);
  const SurfaceTruth truth(folder, scene);
  const int frames = static_cast<int>(found.positions.size());
  std::vector<double> distances;
  const bool has_points = !scene.markers.empty() || !scene.tracks.empty();
  result->attractor = has_points ? 0.0 : NAN;
  for (int f = 0; f < frames; ++f) {
    const Eigen::VectorXd& x = found.positions[static_cast<std::size_t>(f)];
    result->all_pixels += error.OfFrame(f, x) / 7.0 / frames;
    if (has_points) result->attractor += error.MeanAttractor(f, x) / frames;
    for (const double d : truth.PointDistances(f, x)) distances.push_back(d);
  }
  result->truth_rms = 1000.0 * Rms(distances);
  if (frames == 0) return;
  const Eigen::VectorXd true_x = TrueSurface(folder, scene, frames - 1, options.generator);
  result->roughness = Roughness(scene.mesh, found.positions.back());
  result->true_roughness = Roughness(scene.mesh, true_x);
  if (!fit.keep_surface) return;
  const Eigen::VectorXd& last = found.positions.back();
  result->surface.assign(last.data(), last.data() + last.size());
  result->true_surface.assign(true_x.data(), true_x.data() + true_x.size());
}

nlohmann::json ToJson(const StudyFitResult& result) {
  nlohmann::json history = nlohmann::json::array();
  for (const SearchPoint& point : result.history)
    history.push_back({point.simulations, point.seconds, point.error});
  return {{"error", result.error},
          {"all_pixels", result.all_pixels},
          {"attractor", result.attractor},
          {"truth_rms", result.truth_rms},
          {"roughness", result.roughness},
          {"true_roughness", result.true_roughness},
          {"simulations", result.simulations},
          {"seconds", result.seconds},
          {"unknowns", result.unknowns},
          {"converged", result.converged},
          {"reason", result.reason},
          {"history", history},
          {"surface", result.surface},
          {"true_surface", result.true_surface},
          {"fabric", result.fabric}};
}

// What JSON has no word for is null: a number that is none, or infinite.
double Number(const nlohmann::json& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

}  // namespace

Job FitJob(const std::string& name, const StudyFit& fit, const StudyOptions& options) {
  return {name,
          {{"experiment", fit.experiment},
           {"search", fit.search},
           {"points", fit.points},
           {"linear", fit.linear},
           {"reciprocal", fit.reciprocal},
           {"alpha", fit.alpha},
           {"beta", fit.beta},
           {"cameras", fit.cameras},
           {"start", fit.start},
           {"keep_surface", fit.keep_surface},
           {"simulations", options.simulations},
           {"seed", options.seed}}};
}

StudyFit StudyFitOf(const Job& job) {
  const nlohmann::json& input = job.input;
  StudyFit fit;
  fit.experiment = input.at("experiment");
  fit.search = input.at("search");
  fit.points = input.at("points");
  fit.linear = input.at("linear");
  fit.reciprocal = input.at("reciprocal");
  fit.alpha = input.at("alpha");
  fit.beta = input.at("beta");
  fit.cameras = input.at("cameras");
  fit.start = input.at("start");
  fit.keep_surface = input.at("keep_surface");
  return fit;
}

nlohmann::json RunStudyFit(const fs::path& recordings, const StudyOptions& options, const Job& job,
                           const JobContext& context) {
  const StudyFit fit = StudyFitOf(job);
  const fs::path folder = SeenFolder(recordings, options, fit.experiment);
  const Recording recording = ReadUsed(folder, fit, options);
  FitConfig config = SceneConfig(recording, fit, options);
  const Scene scene = MakeScene(recording, config);
  SetPull(fit, scene, &config);
  config.alpha = fit.alpha;
  config.beta = fit.beta;
  config.attract = false;
  SearchOptions search;
  search.attract = fit.linear > 0.0 || fit.reciprocal > 0.0;
  search.seed = options.seed + static_cast<unsigned>(fit.start);
  search.stop = context.stop;
  search.budget.evaluations = options.simulations;
  search.under_way = options.under_way;
  search.num_threads = std::min(context.num_threads, options.under_way);
  const SearchResult found = Search(scene, config, search);
  StudyFitResult result;
  result.error = found.error;
  result.simulations = found.simulations;
  result.seconds = found.seconds;
  result.converged = found.converged;
  result.reason = found.reason;
  result.history = found.history;
  const FreeParameters free(config, scene, MakeParameterTable());
  result.unknowns = free.size();
  for (const int entry : free.Fabric())
    result.fabric.push_back(free.UnitValue(entry, found.theta[entry]));
  Judge(folder, fit, options, scene, found, &result);
  return ToJson(result);
}

StudyFitResult ReadStudyFit(const nlohmann::json& output) {
  StudyFitResult result;
  result.error = Number(output.at("error"));
  result.all_pixels = Number(output.at("all_pixels"));
  result.attractor = Number(output.at("attractor"));
  result.truth_rms = Number(output.at("truth_rms"));
  result.roughness = Number(output.at("roughness"));
  result.true_roughness = Number(output.at("true_roughness"));
  result.simulations = Number(output.at("simulations"));
  result.seconds = Number(output.at("seconds"));
  result.unknowns = output.at("unknowns");
  result.converged = output.at("converged");
  result.reason = output.at("reason");
  for (const nlohmann::json& point : output.at("history"))
    result.history.push_back({Number(point[0]), Number(point[1]), Number(point[2])});
  result.surface = output.at("surface").get<std::vector<double>>();
  result.true_surface = output.at("true_surface").get<std::vector<double>>();
  result.fabric = output.at("fabric").get<std::vector<double>>();
  return result;
}

}  // namespace clothfit
