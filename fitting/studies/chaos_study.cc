// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/studies/chaos_study.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "autodiff_sim/scenes/contact_scenes.h"
#include "fitting/pictures/line_chart.h"
#include "fitting/pictures/picture.h"

namespace clothfit {
namespace {

constexpr double kFrameRate = 30.0;  // Hz
constexpr double kParted = 0.1;      // of the side: beyond this the runs have little in common

// The particle that is moved: in the middle of the upper half.
int MovedParticle(const ChaosOptions& options) {
  return (3 * options.particles / 4) * options.particles + options.particles / 2;
}

double RootMeanSquare(const Eigen::VectorXd& d) {
  return std::sqrt(3.0 * d.squaredNorm() / static_cast<double>(d.size()));
}

double Largest(const Eigen::VectorXd& d) {
  double largest = 0.0;
  for (Eigen::Index i = 0; i < d.size(); i += 3)
    largest = std::max(largest, d.segment<3>(i).norm());
  return largest;
}

ChaosFrame MakeFrame(const ChaosOptions& options, const State& given, const State& moved,
                     const Sensitivity& sensitivity) {
  ChaosFrame frame;
  frame.time = given.time;
  frame.x = given.x;
  frame.moved = moved.x;
  frame.rms = RootMeanSquare(moved.x - given.x);
  frame.largest = Largest(moved.x - given.x);
  frame.sensitivity = RootMeanSquare(sensitivity.x().col(0));
  frame.predicted = options.offset * frame.sensitivity;
  return frame;
}

double MeanGrowth(const ChaosOptions& options, const std::vector<ChaosFrame>& frames) {
  if (frames.size() < 2) return 0.0;
  std::size_t last = frames.size() - 1;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    if (frames[i].rms > kParted * options.side) {
      last = i;
      break;
    }
  }
  return std::log(frames[last].sensitivity / frames[0].sensitivity) /
         (frames[last].time - frames[0].time);
}

}  // namespace

ChaosResult RunChaosStudy(const ChaosOptions& options, const std::function<void(int)>& progress) {
  ChaosResult result;
  const ClothScene scene = DroppedCloth(options.particles, options.side);
  result.mesh = scene.mesh;
  SimulationOptions steps;
  steps.self_contact = options.self_contact;
  steps.tolerance = 1e-7;
  Simulation simulation(scene.mesh, scene.world, {}, steps),
      other(scene.mesh, scene.world, {}, steps);
  const int particle = MovedParticle(options);
  State given = simulation.MakeState(scene.x);
  State moved = given;
  const Eigen::Index row = 3 * static_cast<Eigen::Index>(particle) + 1;
  moved.x[row] += options.offset;
  moved.previous_x = moved.x;
  Sensitivity sensitivity(given, Eigen::MatrixXd::Zero(simulation.parameters().size(), 1));
  Eigen::MatrixXd dx = Eigen::MatrixXd::Zero(given.x.size(), 1);
  dx(row, 0) = 1.0;
  sensitivity.SetInitial(dx, Eigen::MatrixXd::Zero(given.x.size(), 1));
  const Drive nothing = FreeDrive();
  const int frames = static_cast<int>(std::lround(options.duration * kFrameRate));
  const int per_frame =
      std::max(1, static_cast<int>(std::lround(1.0 / (kFrameRate * options.step))));
  const double h = 1.0 / (kFrameRate * per_frame);
  result.frames.push_back(MakeFrame(options, given, moved, sensitivity));
  for (int frame = 1; frame <= frames; ++frame) {
    for (int k = 0; k < per_frame; ++k) {
      if (simulation.Advance(h, nothing, &given, &sensitivity).status != StepStatus::kConverged ||
          other.Advance(h, nothing, &moved).status != StepStatus::kConverged) {
        return result;
      }
    }
    ChaosFrame now = MakeFrame(options, given, moved, sensitivity);
    const ChaosFrame& before = result.frames.back();
    now.growth = std::log(now.sensitivity / before.sensitivity) / (now.time - before.time);
    result.intersections +=
        simulation.CountIntersections(given.x) + other.CountIntersections(moved.x);
    result.frames.push_back(now);
    if (progress) progress(frame);
  }
  result.mean_growth = MeanGrowth(options, result.frames);
  result.complete = true;
  return result;
}

std::string ChaosAsCsv(const ChaosResult& result) {
  std::string text = "time,rms,largest,sensitivity,predicted,growth\n";
  for (const ChaosFrame& f : result.frames) {
    text += fmt::format("{:.6f},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", f.time, f.rms, f.largest,
                        f.sensitivity, f.predicted, f.growth);
  }
  return text;
}

std::string ChaosAsMarkdown(const ChaosOptions& options, const ChaosResult& result) {
  std::string text = fmt::format(
      "{0} x {0} particles, {1} m x {1} m; one of them moved by {2} m. Self-contact {3}; {4} "
      "intersections in all frames of both.\n\n"
      "| time, s | apart, rms, mm | apart, most, mm | derivative, rms | it predicts, mm | growth, "
      "1/s |\n|---:|---:|---:|---:|---:|---:|\n",
      options.particles, options.side, options.offset, options.self_contact ? "on" : "off",
      result.intersections);
  const std::size_t every = std::max<std::size_t>(1, result.frames.size() / 12);
  for (std::size_t i = 0; i < result.frames.size(); i += every) {
    const ChaosFrame& f = result.frames[i];
    text += fmt::format("| {:.2f} | {:.3g} | {:.3g} | {:.3g} | {:.3g} | {:.1f} |\n", f.time,
                        1e3 * f.rms, 1e3 * f.largest, f.sensitivity, 1e3 * f.predicted, f.growth);
  }
  return text + fmt::format(
                    "\nMean growth until the runs have parted: {:.1f} 1/s, a doubling "
                    "every {:.2f} s.\n",
                    result.mean_growth, std::log(2.0) / result.mean_growth);
}

std::string ChaosAsSvg(const ChaosResult& result) {
  ChartLine rms{"two runs, rms", {}, false, false}, largest{"two runs, farthest", {}, false, false};
  ChartLine predicted{"derivative times offset, rms", {}, false, false};
  ChartLine growth{"growth of the derivative", {}, false, false};
  for (const ChaosFrame& f : result.frames) {
    rms.points.emplace_back(f.time, f.rms);
    largest.points.emplace_back(f.time, f.largest);
    predicted.points.emplace_back(f.time, f.predicted);
    growth.points.emplace_back(f.time, f.growth);
  }
  return ChartsAsSvg({{"Apart", "time, s", "distance, m", false, true, {rms, largest, predicted}},
                      {"Growth", "time, s", "1/s", false, false, {growth}}});
}

void DrawChaos(const ChaosOptions& options, const ChaosResult& result, const std::string& file) {
  std::vector<std::vector<ClothPanel>> rows(2);
  const std::size_t last = result.frames.size() - 1;
  for (const std::size_t i : {last / 6, last / 3, last / 2, last}) {
    const ChaosFrame& frame = result.frames[i];
    const Eigen::Map<const Eigen::Matrix3Xd> points(frame.x.data(), 3, frame.x.size() / 3);
    const Eigen::Vector3d centre = points.rowwise().mean();
    rows[0].push_back({fmt::format("{:.2f} s", frame.time), frame.x, centre});
    rows[1].push_back(
        {fmt::format("moved: {:.0f} mm rms apart", 1e3 * frame.rms), frame.moved, centre});
  }
  DrawCloths(result.mesh, rows, 1.5 * options.side, {}, file);
}

}  // namespace clothfit
